#include "case/tables/case_info.hpp"

#include "case/tables/common_checks.hpp"
#include "case/tables/given_words.hpp"

namespace thalweg {

void CaseInfo::set_defaults(const GivenWords& given) { name = given.folder.filename().string(); }

void CaseInfo::check(const Case&, const CheckContext& at) const {
  check_file_name(at, name);
  check_line_of_text(at, "title", title);
}

}  // namespace thalweg

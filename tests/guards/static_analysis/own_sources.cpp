// A plugin of clang 14 that keeps clang-tidy away from what stands in the libraries' headers.
//
// clang-tidy matches its checks against every declaration of a unit, and then drops what it found in library headers. Of a
// unit that includes VTK or CGAL more than nine tenths are such declarations. The plugin narrows the traversal to the
// declarations of the project before the checks run. It also lets the parser skip the bodies of library functions; clang
// still reads those that it needs for a constant or for a deduced type. No finding in the project's files gets lost.

#include <memory>
#include <string>
#include <vector>

#include <clang/AST/ASTConsumer.h>
#include <clang/AST/ASTContext.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendPluginRegistry.h>

namespace {

class OwnSources : public clang::ASTConsumer {
 public:
  explicit OwnSources(const clang::SourceManager& sources) : sources_(sources) {}

  void HandleTranslationUnit(clang::ASTContext& context) override {
    std::vector<clang::Decl*> own;
    for (clang::Decl* declaration : context.getTranslationUnitDecl()->decls()) {
      if (!of_a_library(*declaration)) own.push_back(declaration);
    }
    context.setTraversalScope(own);
  }

  bool shouldSkipFunctionBody(clang::Decl* function) override { return of_a_library(*function); }

 private:
  bool of_a_library(const clang::Decl& declaration) const {
    const clang::SourceLocation place = declaration.getLocation();
    return place.isInvalid() || sources_.isInSystemHeader(sources_.getExpansionLoc(place));
  }

  const clang::SourceManager& sources_;
};

class OwnSourcesOnly : public clang::PluginASTAction {
  ActionType getActionType() override { return AddBeforeMainAction; }

  bool ParseArgs(const clang::CompilerInstance&, const std::vector<std::string>&) override { return true; }

  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance& compiler, llvm::StringRef) override {
    compiler.getFrontendOpts().SkipFunctionBodies = true;
    return std::make_unique<OwnSources>(compiler.getSourceManager());
  }
};

const clang::FrontendPluginRegistry::Add<OwnSourcesOnly> registered("own-sources", "narrows clang-tidy to the project");

}  // namespace

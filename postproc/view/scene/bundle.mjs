// Bundles scene.js with what it uses of vtk.js into one file: node bundle.mjs OUTPUT
// The licences of the packages that end up in it stand at its head, as they ask for.
import { build } from "esbuild";
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const output = process.argv[2];
const result = await build({
  entryPoints: ["scene.js"], bundle: true, minify: true, format: "iife", charset: "ascii", legalComments: "inline",
  metafile: true, write: false, logLevel: "error", outfile: output,
});

const packages = new Set(Object.keys(result.metafile.inputs)
  .map((file) => file.match(/^node_modules\/((?:@[^/]+\/)?[^/]+)\//)?.[1]).filter(Boolean));
const licences = [...packages].sort().map((name) => {
  const folder = join("node_modules", name);
  const about = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
  const text = file && existsSync(join(folder, file)) ? readFileSync(join(folder, file), "utf8").trim() : "";
  return `${name} ${about.version} (${about.license})\n${text}`.replaceAll("*/", "* /");
});
const code = result.outputFiles[0].text.replaceAll("</script", "<\\/script");
writeFileSync(output, `/*\n${licences.join("\n\n")}\n*/\n${code}`);

// The report's 3-D view: bed and free surface of a run between its walls, with a slider for the time. The data are in the page, base64 of
// little-endian arrays: points (float32, m), triangles (uint32), change of the bed's level (float32, m).
import "@kitware/vtk.js/Rendering/Profiles/Geometry";
import vtkActor from "@kitware/vtk.js/Rendering/Core/Actor";
import vtkColorTransferFunction from "@kitware/vtk.js/Rendering/Core/ColorTransferFunction";
import vtkDataArray from "@kitware/vtk.js/Common/Core/DataArray";
import vtkGenericRenderWindow from "@kitware/vtk.js/Rendering/Misc/GenericRenderWindow";
import vtkMapper from "@kitware/vtk.js/Rendering/Core/Mapper";
import vtkPolyData from "@kitware/vtk.js/Common/DataModel/PolyData";
import vtkPolyDataNormals from "@kitware/vtk.js/Filters/Core/PolyDataNormals";

const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;
const floats = (text) => new Float32Array(bytes(text));

// vtk.js wants a count before each triangle's corners.
function cells(text) {
  const corners = new Uint32Array(bytes(text));
  const list = new Uint32Array((corners.length / 3) * 4);
  for (let t = 0; t < corners.length / 3; ++t) list.set([3, corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]], 4 * t);
  return list;
}

function surface(frame) {
  const data = vtkPolyData.newInstance();
  data.getPoints().setData(floats(frame.points), 3);
  data.getPolys().setData(cells(frame.triangles));
  if (frame.change) {
    data.getPointData().setScalars(vtkDataArray.newInstance({ name: "change", values: floats(frame.change) }));
  }
  const normals = vtkPolyDataNormals.newInstance();
  normals.setInputData(data);
  normals.update();
  return normals.getOutputData();
}

function bedColours(largest) {
  // Blue-green where the bed has sunk, brown where it has risen (ColorBrewer's BrBG), as in the report's map.
  const colours = vtkColorTransferFunction.newInstance();
  colours.addRGBPoint(-largest, 0.0, 0.35, 0.32);
  colours.addRGBPoint(-largest / 2, 0.35, 0.71, 0.67);
  colours.addRGBPoint(0, 0.87, 0.8, 0.66);
  colours.addRGBPoint(largest / 2, 0.75, 0.51, 0.18);
  colours.addRGBPoint(largest, 0.33, 0.19, 0.02);
  colours.setNanColor(0.8, 0.8, 0.8, 1);
  return colours;
}

function start() {
  const scene = JSON.parse(document.getElementById("scene-data").textContent);
  const root = document.getElementById("scene");
  const view = vtkGenericRenderWindow.newInstance({ background: [1, 1, 1] });
  view.setContainer(root.querySelector(".canvas"));
  const renderer = view.getRenderer();

  const bed = vtkMapper.newInstance({ useLookupTableScalarRange: true });
  bed.setLookupTable(bedColours(scene.largest));
  const bedActor = vtkActor.newInstance();
  bedActor.setMapper(bed);
  const water = vtkMapper.newInstance({ scalarVisibility: false });
  const waterActor = vtkActor.newInstance();
  waterActor.setMapper(water);
  waterActor.getProperty().setColor(0.3, 0.55, 0.8);
  waterActor.getProperty().setOpacity(0.25);
  waterActor.getProperty().setSpecular(0.3);
  for (const actor of [bedActor, waterActor]) {
    actor.setVisibility(false); // until it has a surface: the view draws before that
    renderer.addActor(actor);
  }

  // Piers and other bodies are solid; the walls around the flow let it be seen.
  for (const [walls, grey, opacity] of [[scene.bodies, 0.42, 1], [scene.walls, 0.6, 0.12]]) {
    if (!walls) continue;
    const mapper = vtkMapper.newInstance({ scalarVisibility: false });
    mapper.setInputData(surface(walls));
    const actor = vtkActor.newInstance();
    actor.setMapper(mapper);
    actor.getProperty().setColor(grey, grey, grey);
    actor.getProperty().setOpacity(opacity);
    renderer.addActor(actor);
  }

  const slider = root.querySelector("input[type=range]");
  const clock = root.querySelector("output");
  const show = () => {
    const frame = scene.frames[slider.value];
    clock.textContent = `t = ${frame.time.toFixed(3)} s`;
    bedActor.setVisibility(Boolean(frame.bed));
    if (frame.bed) bed.setInputData((frame.bed.made ??= surface(frame.bed)));
    waterActor.setVisibility(Boolean(frame.water) && root.querySelector("[name=water]").checked);
    if (frame.water) water.setInputData((frame.water.made ??= surface(frame.water)));
    view.getRenderWindow().render();
  };
  slider.max = scene.frames.length - 1;
  slider.value = slider.max;
  slider.addEventListener("input", show);
  root.querySelector("[name=water]").addEventListener("change", show);
  let timer = 0;
  const play = root.querySelector("button");
  play.addEventListener("click", () => {
    if (timer) {
      clearInterval(timer);
      timer = 0;
    } else {
      timer = setInterval(() => {
        slider.value = (Number(slider.value) + 1) % scene.frames.length;
        show();
      }, 250);
    }
    play.textContent = timer ? "stop" : "play";
  });

  view.resize();
  show();
  const camera = renderer.getActiveCamera();
  camera.setViewUp(0, 0, 1);
  camera.setFocalPoint(0, 0, 0);
  camera.setPosition(0.3, -1, 0.7);
  renderer.resetCamera();
  const [width, height] = view.getApiSpecificRenderWindow().getSize();
  camera.zoom(Math.min(1.9, (0.9 * width) / height)); // a flume is long: fill the width
  renderer.resetCameraClippingRange();
  view.getRenderWindow().render();
  window.addEventListener("resize", () => view.resize());
  root.dataset.drawn = "yes";
}

start();

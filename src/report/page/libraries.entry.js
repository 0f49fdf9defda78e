// What a report takes of other libraries. To make libraries.js of it anew, in an empty folder with this file:
//   npm install three@0.170.0 uplot@1.6.31 esbuild@0.24.0
//   npx esbuild libraries.entry.js --bundle --minify --format=iife --global-name=lib --target=es2020 --outfile=libraries.js
export {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DataTexture, GLSL3, LinearFilter, OrthographicCamera, PerspectiveCamera, Plane, Points,
  RGBAFormat, Scene, ShaderMaterial, Vector3, WebGLRenderer,
} from "three";
export { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
export { default as uPlot } from "uplot";

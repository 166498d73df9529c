export * from "./meshes.js";
export * from "./robot.js";

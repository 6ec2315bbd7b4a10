// Writes small glTF files by @gltf-transform/core and /extensions, for the tests of the reader.
import { Document, NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS, KHRLightsPunctual, KHRMaterialsTransmission, KHRMaterialsVolume, KHRMaterialsIOR, KHRMaterialsDispersion, KHRMaterialsIridescence, KHRMaterialsClearcoat, KHRMaterialsSpecular, KHRMaterialsEmissiveStrength, Light } from '@gltf-transform/extensions';
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS);
function cube(doc, buffer, size, material) { // 24 vertices, with normals and texture coordinates
  const p = [], n = [], uv = [], idx = [];
  for (let axis = 0; axis < 3; ++axis) for (const s of [-1, 1]) {
    const base = p.length / 3, a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (const [u, v] of [[-1,-1],[1,-1],[1,1],[-1,1]]) {
      const c = [0,0,0]; c[axis] = s; c[a] = u; c[b] = v;
      p.push(...c.map(x => x * size)); const m = [0,0,0]; m[axis] = s; n.push(...m); uv.push((u+1)/2, (v+1)/2);
    }
    const q = s > 0 ? [0,1,2,0,2,3] : [0,2,1,0,3,2]; idx.push(...q.map(i => base + i));
  }
  return doc.createPrimitive()
    .setAttribute('POSITION', doc.createAccessor().setType('VEC3').setArray(new Float32Array(p)).setBuffer(buffer))
    .setAttribute('NORMAL', doc.createAccessor().setType('VEC3').setArray(new Float32Array(n)).setBuffer(buffer))
    .setAttribute('TEXCOORD_0', doc.createAccessor().setType('VEC2').setArray(new Float32Array(uv)).setBuffer(buffer))
    .setIndices(doc.createAccessor().setType('SCALAR').setArray(new Uint16Array(idx)).setBuffer(buffer))
    .setMaterial(material);
}
function quad(doc, buffer, half, material) {
  const h = half;
  return doc.createPrimitive()
    .setAttribute('POSITION', doc.createAccessor().setType('VEC3').setArray(new Float32Array([-h,0,h, h,0,h, h,0,-h, -h,0,-h])).setBuffer(buffer))
    .setAttribute('TEXCOORD_0', doc.createAccessor().setType('VEC2').setArray(new Float32Array([0,1, 1,1, 1,0, 0,0])).setBuffer(buffer))
    .setIndices(doc.createAccessor().setType('SCALAR').setArray(new Uint16Array([0,1,2,0,2,3])).setBuffer(buffer))
    .setMaterial(material);
}
{ // A glass cube on a floor, with lights of each kind and a camera.
  const doc = new Document(); const buffer = doc.createBuffer();
  const tr = doc.createExtension(KHRMaterialsTransmission), vo = doc.createExtension(KHRMaterialsVolume),
    ior = doc.createExtension(KHRMaterialsIOR), di = doc.createExtension(KHRMaterialsDispersion),
    li = doc.createExtension(KHRLightsPunctual);
  const glass = doc.createMaterial('glass').setMetallicFactor(0).setRoughnessFactor(0).setBaseColorFactor([1,1,1,1])
    .setExtension('KHR_materials_transmission', tr.createTransmission().setTransmissionFactor(1))
    .setExtension('KHR_materials_volume', vo.createVolume().setThicknessFactor(1).setAttenuationColor([0.25,0.5,0.75]).setAttenuationDistance(2))
    .setExtension('KHR_materials_ior', ior.createIOR().setIOR(1.6))
    .setExtension('KHR_materials_dispersion', di.createDispersion().setDispersion(0.5));
  const floor = doc.createMaterial('floor').setMetallicFactor(0).setRoughnessFactor(1).setBaseColorFactor([0.5,0.5,0.5,1]).setDoubleSided(true);
  const cubeMesh = doc.createMesh('cube').addPrimitive(cube(doc, buffer, 0.5, glass));
  const floorMesh = doc.createMesh('floor').addPrimitive(quad(doc, buffer, 4, floor));
  const scene = doc.createScene();
  scene.addChild(doc.createNode('floor').setMesh(floorMesh));
  const parent = doc.createNode('parent').setTranslation([1, 0.5, 0]).setScale([2, 1, 1]);
  parent.addChild(doc.createNode('left').setMesh(cubeMesh).setTranslation([-1, 0, 0]).setRotation([0, Math.SQRT1_2, 0, Math.SQRT1_2]));
  parent.addChild(doc.createNode('right').setMesh(cubeMesh).setTranslation([1, 0, 0]));
  scene.addChild(parent);
  const light = (type, name) => li.createLight(name).setType(type);
  scene.addChild(doc.createNode('lamp').setTranslation([0, 5, 0]).setExtension('KHR_lights_punctual', light(Light.Type.POINT, 'bulb').setIntensity(100).setColor([1, 1, 1])));
  scene.addChild(doc.createNode('sun').setRotation([-Math.SQRT1_2, 0, 0, Math.SQRT1_2]).setExtension('KHR_lights_punctual', light(Light.Type.DIRECTIONAL, 'sky').setIntensity(3)));
  scene.addChild(doc.createNode('spot').setTranslation([3, 3, 0]).setRotation([0, Math.SQRT1_2, 0, Math.SQRT1_2]).setExtension('KHR_lights_punctual', light(Light.Type.SPOT, 'beam').setIntensity(50).setInnerConeAngle(0.2).setOuterConeAngle(0.4)));
  scene.addChild(doc.createNode('camera').setTranslation([0, 2, 8]).setCamera(doc.createCamera().setType('perspective').setYFov(0.6).setAspectRatio(1.5).setZNear(0.1)));
  await io.write('glass_cubes.glb', doc);
}
{ // One cube in each of the materials, without camera and lamp.
  const doc = new Document(); const buffer = doc.createBuffer(); const scene = doc.createScene();
  const ext = c => doc.createExtension(c);
  const list = [
    ['gold', m => m.setBaseColorFactor([1, 0.7, 0.3, 1]).setMetallicFactor(1).setRoughnessFactor(0.3)],
    ['plastic', m => m.setBaseColorFactor([0.8, 0.1, 0.1, 1]).setMetallicFactor(0).setRoughnessFactor(0.4)],
    ['pane', m => m.setBaseColorFactor([0.9, 1, 0.9, 1]).setMetallicFactor(0).setRoughnessFactor(0)
      .setExtension('KHR_materials_transmission', ext(KHRMaterialsTransmission).createTransmission().setTransmissionFactor(1))],
    ['film', m => m.setMetallicFactor(1).setRoughnessFactor(0)
      .setExtension('KHR_materials_iridescence', ext(KHRMaterialsIridescence).createIridescence().setIridescenceFactor(1).setIridescenceIOR(1.4).setIridescenceThicknessMaximum(350))],
    ['lacquer', m => m.setBaseColorFactor([0.1, 0.1, 0.6, 1]).setMetallicFactor(0).setRoughnessFactor(0.8)
      .setExtension('KHR_materials_clearcoat', ext(KHRMaterialsClearcoat).createClearcoat().setClearcoatFactor(1).setClearcoatRoughnessFactor(0.1))],
    ['dull', m => m.setMetallicFactor(0).setRoughnessFactor(0.5).setBaseColorFactor([0.5, 0.5, 0.5, 1])
      .setExtension('KHR_materials_specular', ext(KHRMaterialsSpecular).createSpecular().setSpecularFactor(0.25))],
    ['masked', m => m.setBaseColorFactor([1, 1, 1, 0.4]).setAlphaMode('MASK').setAlphaCutoff(0.5)],
    ['half', m => m.setBaseColorFactor([0.6, 0.6, 0.6, 0.5]).setMetallicFactor(0).setRoughnessFactor(1).setAlphaMode('BLEND')],
    ['half metal', m => m.setBaseColorFactor([0.6, 0.6, 0.6, 1]).setMetallicFactor(0.5).setRoughnessFactor(0.5)],
  ];
  list.forEach(([name, set], i) => {
    const m = doc.createMaterial(name); set(m);
    const prim = name === 'pane' ? quad(doc, buffer, 0.5, m) : cube(doc, buffer, 0.5, m);
    scene.addChild(doc.createNode(name).setMesh(doc.createMesh(name).addPrimitive(prim)).setTranslation([1.5 * (i % 3), 0, 1.5 * Math.floor(i / 3)]));
  });
  await io.write('materials.glb', doc);
}
{ // A lamp: a quad that emits.
  const doc = new Document(); const buffer = doc.createBuffer(); const scene = doc.createScene();
  const m = doc.createMaterial('lamp').setBaseColorFactor([0, 0, 0, 1]).setMetallicFactor(0).setRoughnessFactor(1).setEmissiveFactor([1, 1, 1])
    .setExtension('KHR_materials_emissive_strength', doc.createExtension(KHRMaterialsEmissiveStrength).createEmissiveStrength().setEmissiveStrength(20));
  scene.addChild(doc.createNode('lamp').setMesh(doc.createMesh().addPrimitive(quad(doc, buffer, 1, m))));
  scene.addChild(doc.createNode('camera').setTranslation([0, 3, 0]).setRotation([-Math.SQRT1_2, 0, 0, Math.SQRT1_2]).setCamera(doc.createCamera().setType('orthographic').setXMag(2).setYMag(1).setZNear(0.1).setZFar(10)));
  await io.write('lamp.gltf', doc);
}

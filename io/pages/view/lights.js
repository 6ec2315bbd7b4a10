// Lights that are switched and dimmed in the page. The light of each is a part of the picture: either a
// layer of the file ("light_key.R"), or a file of its own (render --relightable).

class Lights {
  constructor() {
    this.parts = []; // {name, strength, on, colors}
  }

  // The lights that belong to a picture.
  static async of(picture, pictures) {
    const lights = new Lights();
    if (picture.lightGroup) {
      for (const group of pictures)
        if (group.lightGroup && group.width === picture.width && group.height === picture.height)
          lights.parts.push({name: group.lightGroup, colors: (await group.load()).colors});
    } else {
      for (const [name, channels] of layersOf(picture))
        if (name.startsWith('light_') && channels.length === 3) {
          const colors = await picture.channels(channels.map(channel => channel.place));
          lights.parts.push({name: name.slice('light_'.length), colors});
        }
    }
    for (const part of lights.parts) Object.assign(part, {on: true, stops: 0});
    return lights;
  }

  get changed() {
    return this.parts.some(part => !part.on || part.stops !== 0);
  }
  reset() {
    for (const part of this.parts) Object.assign(part, {on: true, stops: 0});
  }
  // The sum of all lights as they are set.
  sum() {
    const sum = new Float32Array(this.parts[0].colors.length);
    for (const part of this.parts) {
      if (!part.on) continue;
      const strength = 2 ** part.stops, {colors} = part;
      for (let i = 0; i < sum.length; ++i) sum[i] += strength * colors[i];
    }
    return sum;
  }

  // Fills an element with a switch and a slider for each light.
  show(element, changed) {
    element.replaceChildren(...this.parts.map((part, number) => {
      const label = document.createElement('label'), name = document.createElement('span');
      const on = Object.assign(document.createElement('input'), {type: 'checkbox', checked: part.on});
      const stops = Object.assign(document.createElement('input'),
                                  {type: 'range', min: -5, max: 5, step: 0.25, value: part.stops});
      const told = document.createElement('output');
      const tell = () => { told.textContent = `${part.stops > 0 ? '+' : ''}${part.stops} EV`; };
      on.id = `light-${number}`;
      on.onchange = () => { part.on = on.checked; changed(); };
      stops.oninput = () => { part.stops = +stops.value; tell(); changed(); };
      stops.setAttribute('aria-label', `${part.name}, stops`);
      name.textContent = part.name;
      tell();
      label.append(on, name, stops, told);
      return label;
    }));
  }
}

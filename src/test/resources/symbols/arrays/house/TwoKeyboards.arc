package house;

import house.Colours.Colour;

component TwoKeyboards {
    port in Boolean key[6], in Colour lamp[2], out Integer[0..2] pressed[2];

    component Keys keyboard[2];

    connect key -> keyboard.key;
    connect lamp -> keyboard[0].lamp, keyboard[1].lamp;
    connect lamp[0] -> keyboard.shade;
    connect keyboard[0].pressed -> pressed[0];
    connect keyboard[1].pressed -> pressed[1];
}

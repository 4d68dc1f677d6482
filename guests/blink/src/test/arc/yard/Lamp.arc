package yard;

component Lamp {
    timing instant;
    port out Boolean lit;

    blink lit { on 2, off 1 }
}

package nxt;

import nxt.Brick.Key;

/** A key of the brick, sampled once per slice: a press between two samples goes unseen. */
<<platform, layer = "sensors">> component Button(Key key) {
    /** Whether the key is held down. */
    port <<total>> out Boolean pressed;
}

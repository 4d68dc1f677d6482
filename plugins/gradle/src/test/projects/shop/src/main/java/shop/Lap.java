package shop;

import shop.logic.Bumper;

/** Hand-written code that uses what is generated. */
public final class Lap {
    private final Bumper bumper = new Bumper();
}

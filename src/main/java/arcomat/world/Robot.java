package arcomat.world;

import arcomat.source.Span;

/**
 * A robot as the world begins.
 *
 * @param name of its brick
 * @param place where the world says so
 */
public record Robot(String name, Kind kind, Pose pose, Cup cup, Span place) {
    Disc disc() {
        return kind.body(pose);
    }
}

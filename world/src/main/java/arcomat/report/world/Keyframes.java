package arcomat.report.world;

import static arcomat.report.world.WorldAnimation.number;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * What moves and what is seen for a while, as animations of CSS, and the attributes of the shapes
 * that take part in them.
 */
final class Keyframes {
    /** Percent of the time in which it runs; then one sees how it ended, before it begins anew. */
    private static final double MOVED = 94;

    private final int frames;
    private final StringBuilder css = new StringBuilder();
    private int count;

    /**
     * @param frames of the run
     */
    Keyframes(int frames) {
        this.frames = frames;
    }

    /**
     * @param duration of the run, in milliseconds
     */
    static double seconds(int duration) {
        return duration / (10 * MOVED);
    }

    String css() {
        return css.toString();
    }

    /** For a shape around (0, 0) with its front to the right. */
    String turning(List<Motion.Place> places) {
        return alongWay(
                places,
                place ->
                        "translate(%spx, %spx) rotate(%sdeg)"
                                .formatted(
                                        number(place.x()),
                                        number(place.y()),
                                        number(place.turned())));
    }

    /** For a shape around (0, 0) that stays upright. */
    String moving(List<Motion.Place> places) {
        return alongWay(
                places,
                place -> "translate(%spx, %spx)".formatted(number(place.x()), number(place.y())));
    }

    private String alongWay(List<Motion.Place> places, Function<Motion.Place, String> transform) {
        List<Integer> kept = Motion.frames(places);
        String first = transform.apply(places.get(0));
        if (kept.stream().allMatch(i -> transform.apply(places.get(i)).equals(first))) {
            return " style=\"transform: " + first + "\"";
        }
        String name = begin();
        kept.forEach(i -> step(i, "transform: " + transform.apply(places.get(i))));
        end("transform: " + transform.apply(places.get(frames - 1)));
        return " style=\"animation-name: " + name + "; transform: " + first + "\"";
    }

    /** For a shape that is seen at some of the frames; empty if at none. */
    Optional<String> seenWhile(IntPredicate isSeen) {
        if (IntStream.range(0, frames).noneMatch(isSeen)) {
            return Optional.empty();
        }
        if (IntStream.range(0, frames).allMatch(isSeen)) {
            return Optional.of("");
        }
        String name = begin();
        for (int i = 0; i < frames; i++) {
            if (i == 0 || isSeen.test(i) != isSeen.test(i - 1)) {
                step(i, visibility(isSeen.test(i)));
            }
        }
        end(visibility(isSeen.test(frames - 1)));
        return Optional.of(
                " style=\"animation-name: %s; animation-timing-function: step-end; %s\""
                        .formatted(name, visibility(isSeen.test(0))));
    }

    private static String visibility(boolean isSeen) {
        return "visibility: " + (isSeen ? "visible" : "hidden");
    }

    private String begin() {
        String name = "run" + count++;
        css.append("@keyframes ").append(name).append(" {");
        return name;
    }

    private void step(int frame, String what) {
        double percent = frames < 2 ? 0 : MOVED * frame / (frames - 1);
        css.append(String.format(Locale.ROOT, " %.2f%% { %s }", percent, what));
    }

    private void end(String what) {
        css.append(" 100% { ").append(what).append(" } }\n");
    }
}

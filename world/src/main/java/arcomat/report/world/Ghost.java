package arcomat.report.world;

import arcomat.report.text.Fields;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Another run that a page shows on the same floor: where its robots were.
 *
 * @param label tells it from the run of the page
 * @param period from one frame to the next, in milliseconds
 * @param robots their names
 * @param frames of each, for each robot x, y and heading
 */
public record Ghost(
        String label, int period, List<String> robots, List<List<List<Double>>> frames) {
    /** How many numbers of a robot come first: x, y, heading. */
    private static final int PLACE = 3;

    public Ghost {
        robots = List.copyOf(robots);
        frames = List.copyOf(frames);
    }

    /**
     * Of a recording as {@link WorldJson} writes it; empty where a text is none.
     *
     * @param name of the recording, for people
     */
    public static Optional<Ghost> read(String text, String name) {
        JsonNode json;
        try {
            json = new ObjectMapper().readTree(text);
        } catch (JsonProcessingException e) {
            return Optional.empty();
        }
        List<String> robots = new ArrayList<>();
        json.at("/world/robots").forEach(robot -> robots.add(robot.path("name").asText()));
        List<List<List<Double>>> frames = new ArrayList<>();
        for (JsonNode frame : json.path("frames")) {
            List<List<Double>> places = new ArrayList<>();
            frame.path("robots").forEach(robot -> places.add(place(robot)));
            frames.add(places);
        }
        int period = json.path("period").asInt();
        boolean whole =
                frames.stream()
                        .allMatch(
                                places ->
                                        places.size() == robots.size()
                                                && places.stream()
                                                        .allMatch(each -> each.size() == PLACE));
        return whole && period > 0 && !robots.isEmpty() && !frames.isEmpty()
                ? Optional.of(
                        new Ghost(
                                name + ", seed " + json.path("seed").asLong(),
                                period,
                                robots,
                                frames))
                : Optional.empty();
    }

    private static List<Double> place(JsonNode robot) {
        List<Double> numbers = new ArrayList<>();
        for (int i = 0; i < PLACE && robot.path(i).isNumber(); i++) {
            numbers.add(robot.path(i).asDouble());
        }
        return numbers;
    }

    Fields json() {
        return Fields.of("label", label)
                .with("period", period)
                .with("robots", robots)
                .with("frames", frames);
    }
}

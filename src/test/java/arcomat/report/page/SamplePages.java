package arcomat.report.page;

import arcomat.report.page.Page.Tone;
import arcomat.report.page.Story.Drawing;
import arcomat.report.page.Story.Remark;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import java.util.stream.Stream;

/** Pages made by hand, for tests. */
final class SamplePages {
    /** Whatever a browser might take for more than text. */
    static final List<String> HOSTILE =
            List.of(
                    "</script><img src=x onerror=window.hacked=1>",
                    "<!--<script>window.hacked=2",
                    "\"><svg onload=window.hacked=3>",
                    "'-window.hacked-'",
                    "{{data}}{{script}}",
                    "$1\\u003c\\",
                    "]]>&lt;script&gt;",
                    "\u202egnp\ud800\u0000\u2028");

    private SamplePages() {}

    /** Two tracks, ten steps, a flaw in step 7. */
    static Page small() {
        Track.Builder command = new Track.Builder("outputs", "cmd", Track.Kind.PORT);
        Track.Builder state = new Track.Builder("states", "state", Track.Kind.STATE);
        for (int step = 0; step < 10; step++) {
            if (step % 3 == 0) {
                command.add("fwd");
            } else {
                command.addNothing();
            }
            state.add(step < 5 ? "driving" : "backing", List.of("state " + (step < 5 ? 0 : 1)));
        }
        Timeline timeline =
                new Timeline(
                        "slice",
                        10,
                        List.of(),
                        List.of(command.build(), state.build()),
                        List.of(new Timeline.Flaw(7, "cmd", "fwd is missing")));
        String svg =
                "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"arcomat\" width=\"80\""
                    + " height=\"20\" viewBox=\"0 0 80 20\"><g class=\"state\""
                    + " data-state=\"0\"><rect width=\"30\" height=\"20\"/></g><g class=\"state\""
                    + " data-state=\"1\"><rect x=\"40\" width=\"30\" height=\"20\"/></g></svg>";
        Story story =
                new Story(
                        "",
                        Tone.BAD,
                        "",
                        List.of(Remark.of(Tone.BAD, "It should go on.").at(7)),
                        timeline,
                        List.of(new Drawing("the robot", svg, List.of("state"))));
        return new Page("simulate", "p.Robot", Tone.BAD, "it fails", List.of(story));
    }

    /** A part that sends, with a part inside, and a picture of its wire. */
    static Page parts() {
        String svg =
                "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"arcomat\" width=\"80\""
                    + " height=\"40\" viewBox=\"0 0 80 40\"><g class=\"port\""
                    + " data-port=\"a.o\"><rect x=\"10\" y=\"25\" width=\"6\" height=\"6\"/></g><g"
                    + " class=\"connector\" data-connector=\"a.o -> c.i\"><path d=\"M16,28"
                    + " L60,28\"/></g></svg>";
        return parts(svg, Map.of("a.o", "a.o"));
    }

    /** The same with what is inside of part a. */
    static Page nestedParts() {
        String svg =
                """
                <svg xmlns="http://www.w3.org/2000/svg" class="arcomat" width="400" height="100" viewBox="0 0 400 100">
                <g class="part" data-part="a"><rect x="10" y="5" width="290" height="90"/></g>
                <g class="part" data-part="a.b"><rect x="20" y="30" width="80" height="60"/></g>
                <g class="port" data-port="a.b.o"><rect x="97" y="57" width="6" height="6"/></g>
                <g class="connector" data-connector="a.b.o -> o" data-in="a" data-from="a.b.o" data-to="a.o"><path d="M103,60 L297,60"/></g>
                <g class="port" data-port="a.o"><rect x="297" y="57" width="6" height="6"/></g>
                <g class="part" data-part="c"><rect x="350" y="30" width="40" height="60"/></g>
                <g class="port" data-port="c.i"><rect x="347" y="57" width="6" height="6"/></g>
                <g class="connector" data-connector="a.o -> c.i" data-in="" data-from="a.o" data-to="c.i"><path d="M303,60 L347,60"/></g>
                </svg>
                """;
        return parts(svg, Map.of("a.o", "a.o", "a.b.o", "a.b.o"));
    }

    private static Page parts(String svg, Map<String, String> carried) {
        List<Track> tracks =
                List.of(
                        Track.of("inputs", "i", Track.Kind.PORT, Stream.of("a", "", "c", "")),
                        Track.of("inputs", "j", Track.Kind.PORT, Stream.of("", "b", "", "")),
                        Track.of("part a", "a.o", Track.Kind.PORT, Stream.of("", "x", "", "y")),
                        Track.of("part a", "a", Track.Kind.STATE, Stream.of("s", "s", "t", "t")),
                        Track.of("part a.b", "a.b.o", Track.Kind.PORT, Stream.of("1", "", "", "")),
                        Track.of("part c", "c.o", Track.Kind.PORT, Stream.of("2", "", "", "")));
        Drawing drawing = new Drawing("p.Whole", svg, List.of(), carried);
        Timeline timeline = new Timeline("slice", 4, List.of(), tracks, List.of());
        Story story = new Story("", Tone.NEUTRAL, "", List.of(), timeline, List.of(drawing));
        return new Page("simulate", "p.Whole", Tone.NEUTRAL, "4 slices", List.of(story));
    }

    /** Everywhere a text that is up to no good. */
    static Page hostile() {
        return new Page(
                HOSTILE.get(0),
                HOSTILE.get(1),
                Tone.BAD,
                String.join(" ", HOSTILE),
                HOSTILE.stream().map(SamplePages::hostileStory).toList());
    }

    private static Story hostileStory(String text) {
        SourceFile file = new SourceFile(text, text + "\n" + text);
        Remark remark =
                new Remark(
                        Tone.BAD,
                        text,
                        Optional.of(file.span(2, file.text().length() - 2)),
                        OptionalInt.of(1));
        Track.Builder track = new Track.Builder(text, text, Track.Kind.STATE).startingAs(text);
        HOSTILE.forEach(each -> track.add(each, List.of(each, "state " + each)));
        Track.Builder reason = new Track.Builder(text, text + "!", Track.Kind.REASON);
        HOSTILE.forEach(reason::add);
        Timeline timeline =
                new Timeline(
                        text,
                        HOSTILE.size(),
                        List.of(),
                        List.of(track.build(), reason.build()),
                        List.of(new Timeline.Flaw(1, text, text)));
        return new Story(text, Tone.BAD, text, List.of(remark), timeline, List.of());
    }

    /** Many tracks that change all the time. */
    static Page large(int steps, int tracks) {
        Random random = new Random(7);
        List<Track> all =
                random.ints(tracks, 2, 300)
                        .mapToObj(values -> noise(values, steps, random))
                        .toList();
        Timeline timeline = new Timeline("slice", steps, List.of(), named(all), List.of());
        Story story = new Story("", Tone.NEUTRAL, "", List.of(), timeline, List.of());
        return new Page("simulate", "p.Large", Tone.NEUTRAL, "long", List.of(story));
    }

    private static Track noise(int values, int steps, Random random) {
        Track.Builder track = new Track.Builder("inputs", "noise", Track.Kind.PORT);
        for (int step = 0; step < steps; step++) {
            int value = random.nextInt(values + 1);
            if (value == values) {
                track.addNothing();
            } else {
                track.add(values % 2 == 0 ? "v" + value : "" + value);
            }
        }
        return track.build();
    }

    private static List<Track> named(List<Track> tracks) {
        return java.util.stream.IntStream.range(0, tracks.size())
                .mapToObj(
                        i ->
                                new Track(
                                        "inputs",
                                        "noise" + i,
                                        Track.Kind.PORT,
                                        "",
                                        tracks.get(i).values(),
                                        tracks.get(i).runs()))
                .toList();
    }
}

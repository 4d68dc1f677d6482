package arcomat.report;

import arcomat.report.page.Story;
import arcomat.report.page.Track;

import java.util.ArrayList;
import java.util.List;

/** What the rows of a story show, for tests that read pages. */
public final class ShownTracks {
    private ShownTracks() {}

    public static Track track(Story story, String name) {
        return story.timeline().tracks().stream()
                .filter(track -> track.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /** The texts of a track, a dash for nothing. */
    public static List<String> texts(Track track) {
        List<String> texts = new ArrayList<>();
        for (Track.Run run : track.runs()) {
            for (int i = 0; i < run.length(); i++) {
                texts.add(run.value() < 0 ? "-" : track.values().get(run.value()).text());
            }
        }
        return texts;
    }

    /** The elements of drawings that a track marks, step by step. */
    public static List<List<String>> elements(Track track) {
        List<List<String>> elements = new ArrayList<>();
        for (Track.Run run : track.runs()) {
            for (int i = 0; i < run.length(); i++) {
                elements.add(
                        run.value() < 0 ? List.of() : track.values().get(run.value()).elements());
            }
        }
        return elements;
    }
}

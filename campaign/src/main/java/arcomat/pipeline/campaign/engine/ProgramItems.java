package arcomat.pipeline.campaign.engine;

import arcomat.sim.load.NotedLines;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Where one program comes to what runs may cover.
 *
 * @param whole full name of the class of the component that it runs
 * @param automata one for each class that has one
 * @param parts those that are counted by themselves, too
 */
public record ProgramItems(String whole, List<OfClass> automata, List<OfPart> parts) {
    private static final String WHOLE = "whole";
    private static final String AUTOMATON = "automaton";
    private static final String PART = "part";

    public ProgramItems {
        automata = List.copyOf(automata);
        parts = List.copyOf(parts);
    }

    /**
     * Of a class.
     *
     * @param transition number of its first transition, whichever of its objects takes it
     * @param initial number of its first beginning, likewise
     * @param transitions how many it has
     * @param lines for all transitions, then for all beginnings
     */
    public record OfClass(int transition, int initial, int transitions, NotedLines lines) {
        /** The number of what an object of the class has noted. */
        int number(int noted) {
            return noted < transitions ? transition + noted : initial + noted - transitions;
        }
    }

    /**
     * Of a part.
     *
     * @param robot that has the program
     * @param first number of its first transition; the others follow, then its beginnings
     * @param fields that lead from the whole to it, with dots between them; empty for the whole
     */
    public record OfPart(String robot, int first, String fields) {}

    /** What objects of the program are to note; the whole is told from others by noting nothing. */
    List<NotedLines> lines() {
        List<NotedLines> lines = new ArrayList<>();
        automata.forEach(each -> lines.add(each.lines()));
        if (lines.stream().noneMatch(each -> each.type().equals(whole))) {
            lines.add(new NotedLines(whole, List.of()));
        }
        return lines;
    }

    /** What {@link #read} reads. */
    String text() {
        StringBuilder text = new StringBuilder(WHOLE + " " + whole + "\n");
        for (OfClass each : automata) {
            String lines =
                    each.lines().lines().stream()
                            .map(line -> " " + line)
                            .collect(Collectors.joining());
            text.append(
                    "%s %d %d %d %s%s\n"
                            .formatted(
                                    AUTOMATON,
                                    each.transition(),
                                    each.initial(),
                                    each.transitions(),
                                    each.lines().type(),
                                    lines));
        }
        parts.forEach(
                each ->
                        text.append(
                                "%s %s %d %s\n"
                                        .formatted(
                                                PART, each.robot(), each.first(), each.fields())));
        return text.toString();
    }

    /**
     * @throws IOException where it is not the text of one
     */
    static ProgramItems read(String text) throws IOException {
        String whole = "";
        List<OfClass> automata = new ArrayList<>();
        List<OfPart> parts = new ArrayList<>();
        for (String line : text.lines().toList()) {
            List<String> words = Arrays.asList(line.split(" ", -1));
            if (words.get(0).equals(WHOLE) && words.size() == 2) {
                whole = words.get(1);
            } else if (words.get(0).equals(AUTOMATON) && words.size() >= 5) {
                automata.add(ofClass(words));
            } else if (words.get(0).equals(PART) && words.size() == 4) {
                parts.add(new OfPart(words.get(1), ItemProbes.number(words.get(2)), words.get(3)));
            } else {
                throw new IOException("what a program covers: '" + line + "'");
            }
        }
        return new ProgramItems(whole, automata, parts);
    }

    private static OfClass ofClass(List<String> words) throws IOException {
        List<Integer> lines = new ArrayList<>();
        for (String word : words.subList(5, words.size())) {
            lines.add(ItemProbes.number(word));
        }
        return new OfClass(
                ItemProbes.number(words.get(1)),
                ItemProbes.number(words.get(2)),
                ItemProbes.number(words.get(3)),
                new NotedLines(words.get(4), lines));
    }
}

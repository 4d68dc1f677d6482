package arcomat.report.verdict;

import arcomat.analysis.automaton.Examination;
import arcomat.analysis.automaton.Finding;
import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** Answers in a few words, for somebody who sees beside them what they are about. */
public final class VerdictLine {
    /** What findings are about, one and several; codes as for {@code arcomat explain}. */
    private static final Map<String, Noun> NOUNS =
            Map.of(
                    "ARC1001", new Noun("overlap", "overlaps"),
                    "ARC1002", new Noun("gap", "gaps"),
                    "ARC1003", new Noun("unreachable state", "unreachable states"),
                    "ARC1004", new Noun("dead transition", "dead transitions"),
                    "ARC1005", new Noun("trap", "traps"),
                    "ARC1006", new Noun("vacuous on silence", "vacuous on silence"),
                    "ARC1007", new Noun("value outside its range", "values outside their ranges"),
                    "ARC1008", new Noun("division by zero", "divisions by zero"),
                    "ARC1009", new Noun("overflow", "overflows"),
                    "ARC1010", new Noun("forgotten silence", "forgotten silences"));

    private record Noun(String one, String several) {
        String count(long number) {
            return number + " " + (number == 1 ? one : several);
        }
    }

    private VerdictLine() {}

    /** {@code holds, 3 of 3 transitions took part}, {@code fails in 2 steps}. */
    public static String of(Answered answered) {
        Verdict verdict = answered.verdict();
        String line =
                switch (verdict.answer()) {
                    case HOLDS -> "holds";
                    case FAILS -> fails(answered);
                    case UNKNOWN -> "unknown: " + verdict.reason();
                };
        List<String> parts = new ArrayList<>(List.of(line));
        verdict.notes().forEach(note -> parts.add(shortened(note, answered.right())));
        return Printable.escape(String.join(", ", parts));
    }

    private static String fails(Answered answered) {
        int last = answered.verdict().trace().size() - 1;
        if (last < 0) {
            return "fails (" + answered.verdict().reason() + ")";
        }
        return answered.question() == Answered.Question.INVARIANT
                ? "not true in slice " + last
                : "fails in " + FindingsText.count(last, "step");
    }

    /** What the right side is called stands beside it. */
    private static String shortened(String note, String right) {
        String name = right.replaceAll("[^\\s.]+\\.", "");
        return right.isEmpty()
                ? note
                : note.replace("transitions of " + right, "transitions").replace(right, name);
    }

    /**
     * {@code 2 overlaps, 1 unreachable state}.
     *
     * @param examinations of one automaton, with all arguments that it is used with
     */
    public static String of(List<Examination> examinations) {
        Map<String, Long> counts =
                examinations.stream()
                        .map(Examination::findings)
                        .flatMap(Collection::stream)
                        .map(Finding::diagnostic)
                        .distinct()
                        .collect(
                                Collectors.groupingBy(
                                        each -> each.code(), TreeMap::new, Collectors.counting()));
        List<String> parts = new ArrayList<>();
        counts.forEach(
                (code, number) ->
                        parts.add(NOUNS.getOrDefault(code, new Noun(code, code)).count(number)));
        String found = parts.isEmpty() ? "nothing found" : String.join(", ", parts);
        return examinations.stream()
                .map(Examination::obstacle)
                .filter(obstacle -> !obstacle.isEmpty())
                .findFirst()
                .map(obstacle -> found + ", but not all was looked at: " + obstacle)
                .orElse(found);
    }
}

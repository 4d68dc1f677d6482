package arcomat.pipeline.verdict;

import arcomat.analysis.automaton.Examination;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.pipeline.analysis.AnalyzeAutomata.Found;
import arcomat.pipeline.verdict.TextVerdict.Sheet;
import arcomat.pipeline.verdict.TextVerdict.Tone;
import arcomat.report.text.Style;
import arcomat.report.verdict.ExaminationText;
import arcomat.report.verdict.VerdictLine;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** What was found about automata, each at its automaton. */
record AutomatonVerdicts(Found found) {
    List<TextVerdict> at(List<VerdictPlace> places) {
        List<TextVerdict> verdicts = new ArrayList<>();
        for (VerdictPlace place : places) {
            List<Examination> about =
                    found.examinations().stream()
                            .filter(each -> each.automaton().span().equals(place.subject()))
                            .toList();
            if (place.kind() == VerdictPlace.Kind.AUTOMATON && !about.isEmpty()) {
                verdicts.add(verdict(place, about));
            }
        }
        return verdicts;
    }

    private static TextVerdict verdict(VerdictPlace place, List<Examination> about) {
        return new TextVerdict(
                place,
                tone(about),
                VerdictLine.of(about),
                new Sheet(
                        "analyze.txt",
                        () ->
                                about.stream()
                                        .map(each -> ExaminationText.render(each, Style.PLAIN))
                                        .collect(Collectors.joining("\n"))));
    }

    private static Tone tone(List<Examination> about) {
        return about.stream().allMatch(each -> each.answer() == Answer.HOLDS)
                ? Tone.GOOD
                : Tone.OPEN;
    }
}

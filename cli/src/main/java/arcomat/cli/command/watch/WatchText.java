package arcomat.cli.command.watch;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.pipeline.watch.WatchStatus;
import arcomat.pipeline.watch.WatchStatus.State;
import arcomat.pipeline.watch.WatchStatus.Step;
import arcomat.pipeline.watch.WorldEnd;
import arcomat.report.finding.FindingsText;
import arcomat.report.run.StreamTestText;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.verdict.ObligationsText;
import arcomat.report.verdict.VerdictText;
import arcomat.report.world.WorldText;
import arcomat.simulate.test.StreamTestResult;
import arcomat.source.Diagnostic;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;

/**
 * What is broken now, step by step, and in one line how each step stands.
 *
 * @param most findings, tests and promises of a step that are shown; of more it is told how many
 */
record WatchText(WatchStatus now, int most, Style style) {

    /** What is wrong, for people to mend; empty where nothing is. */
    String broken(Step step) {
        return switch (step) {
            case CHECK -> findings(now.check().findings());
            case TEST -> tests();
            case VERIFY -> promises();
            case WORLD -> worlds();
        };
    }

    /** How a step stands; empty where it has nothing to do. */
    String summary(Step step) {
        if (now.state(step) == State.ASKED) {
            return style.quiet("...");
        }
        String done =
                switch (step) {
                    case CHECK ->
                            FindingsText.summary(
                                    now.check().findings(), now.check().files(), style);
                    case TEST ->
                            now.tests().isEmpty() ? "" : StreamTestText.summary(now.tests(), style);
                    case VERIFY ->
                            now.promises().isEmpty()
                                    ? ""
                                    : ObligationsText.summary(verdicts(), style);
                    case WORLD -> worldsInOneLine();
                };
        boolean blocked = now.state(step) == State.BLOCKED;
        String waiting = blocked ? style.warning("some wait until errors are mended") : "";
        return done + (done.isEmpty() || waiting.isEmpty() ? "" : "; ") + waiting;
    }

    /** In one line how all of it stands. */
    String verdict() {
        String trouble =
                now.trouble()
                        .map(
                                error ->
                                        "internal error, this is a fault of arcomat ("
                                                + Printable.escape(error)
                                                + "); it is tried again at the next save\n")
                        .orElse("");
        return trouble
                + switch (now.standing()) {
                    case FINE -> style.good("all is well");
                    case BROKEN -> style.error("something is broken");
                    case UNKNOWN -> style.warning("not all is known");
                };
    }

    private List<Verdict> verdicts() {
        return now.promises().stream().map(Answered::verdict).toList();
    }

    /** Errors first: there may be more warnings than anybody looks at. */
    private String findings(List<Diagnostic> findings) {
        List<Diagnostic> first =
                findings.stream()
                        .sorted(Comparator.comparing(Diagnostic::isError).reversed())
                        .limit(most)
                        .toList();
        return FindingsText.render(first, style) + more(findings.size(), "finding");
    }

    private String tests() {
        List<StreamTestResult> wrong =
                now.tests().stream()
                        .filter(
                                each ->
                                        switch (each.verdict()) {
                                            case FAILED, UNKNOWN -> true;
                                            case PASSED, VACUOUS -> false;
                                        })
                        .toList();
        String shown = StreamTestText.render(wrong.stream().limit(most).toList(), style);
        return shown + more(wrong.size(), "test");
    }

    private String promises() {
        List<Answered> wrong =
                now.promises().stream()
                        .filter(each -> each.verdict().answer() != Answer.HOLDS)
                        .toList();
        return wrong.stream()
                        .limit(most)
                        .map(each -> VerdictText.render(each, style) + "\n")
                        .collect(Collectors.joining())
                + more(wrong.size(), "promise");
    }

    private String worlds() {
        return now.worlds().stream()
                .filter(each -> !each.succeeded())
                .limit(most)
                .map(this::told)
                .collect(Collectors.joining());
    }

    private String told(WorldEnd end) {
        String events =
                end.recording().map(recording -> WorldText.events(recording, style)).orElse("");
        return FindingsText.render(end.findings(), style) + events + ended(end) + "\n\n";
    }

    private String worldsInOneLine() {
        return now.worlds().stream().map(this::ended).collect(Collectors.joining("; "));
    }

    private String ended(WorldEnd end) {
        String how =
                end.recording()
                        .map(WorldText::summary)
                        .or(end::reason)
                        .orElse("it cannot run, there are errors");
        String text = Printable.escape(end.world()) + ": " + how.lines().findFirst().orElse("");
        return end.succeeded() ? style.good(text) : style.error(text);
    }

    private String more(int all, String noun) {
        return all > most ? "and " + FindingsText.count(all - most, "more " + noun) + "\n" : "";
    }
}

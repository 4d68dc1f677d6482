package arcomat.laws;

import arcomat.analysis.refinement.Difference;
import arcomat.analysis.refinement.Difference.Relation;
import arcomat.analysis.refinement.Verdict;
import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.laws.draw.VariedText;
import arcomat.laws.naive.ByHand;
import arcomat.model.Component;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.models.ReadModels;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * A configuration of a component is what somebody writes who knows nothing of features: the same
 * findings, verdicts, and runs, and a recorded test of it passes on the other one.
 */
final class ConfigurationsAsByHand implements Law {
    private static final int SLICES = 10;

    /** What is wrong with features is wrong with nothing else. */
    private static final String ABOUT_FEATURES = "ARC015[0-2]";

    @Override
    public String name() {
        return "11 configurations as by hand";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        List<SourceFile> files = new ArrayList<>(List.of(ComponentText.types()));
        files.addAll(VariedText.of(draw, draw.has(Features.EVENTS) && draw.chance(15)));
        return files;
    }

    @Override
    public Optional<Outcome> checkText(List<SourceFile> files, int seed) {
        Set<String> found = codes(files);
        ByHand hand = new ByHand(files);
        Set<String> expected = codes(hand.written());
        if (found.stream().anyMatch(each -> each.matches(ABOUT_FEATURES))) {
            return Optional.empty();
        }
        if (!found.equals(expected)) {
            return Optional.of(
                    Outcome.broken("check finds other things: " + found + " and " + expected));
        }
        return Models.read(files, seed).map(models -> check(models, hand));
    }

    private static Set<String> codes(List<SourceFile> files) {
        Set<String> codes = new TreeSet<>();
        for (Diagnostic each : Checks.run(ReadModels.workspace(files), Profile.REQUIREMENTS)) {
            codes.add(each.code());
        }
        return codes;
    }

    @Override
    public Outcome check(Models models) {
        return check(models, new ByHand(models.files()));
    }

    private static Outcome check(Models models, ByHand hand) {
        Models written = Models.read(hand.written(), models.seed()).orElseThrow();
        Optional<Component> other = Optional.empty();
        Outcome outcome = Outcome.SKIPPED;
        for (ByHand.Pair each : hand.pairs()) {
            Component configuration = models.component(each.name());
            Component equal = written.component(each.written());
            if (configuration.parameters().isEmpty() && !outcome.isBroken()) {
                outcome = same(configuration, equal, other, models.seed());
                other = Optional.of(equal);
            }
        }
        return outcome;
    }

    private static Outcome same(
            Component configuration, Component equal, Optional<Component> other, int seed) {
        Relation relation =
                Difference.of(
                                Questions.promise(configuration),
                                Questions.promise(equal),
                                Questions.budget())
                        .relation();
        if (relation != Relation.EQUIVALENT && relation != Relation.UNKNOWN) {
            return Outcome.broken(
                    "a configuration is not what is written by hand: " + relation,
                    "diff " + configuration.qualifiedName() + " " + equal.qualifiedName());
        }
        Optional<Outcome> compared = other.flatMap(each -> compared(configuration, equal, each));
        return compared.orElseGet(() -> run(configuration, equal, seed));
    }

    /** Both are asked about a third one, so that nobody can see that they are alike. */
    private static Optional<Outcome> compared(
            Component configuration, Component equal, Component other) {
        Verdict one = Questions.refines(configuration, other);
        Verdict two = Questions.refines(equal, other);
        boolean known =
                one.answer() != Verdict.Answer.UNKNOWN && two.answer() != Verdict.Answer.UNKNOWN;
        return !known || Questions.text(one).equals(Questions.text(two))
                ? Optional.empty()
                : Optional.of(
                        Outcome.broken(
                                "verdicts differ: "
                                        + Questions.text(one)
                                        + " and "
                                        + Questions.text(two),
                                Questions.command(
                                        configuration.qualifiedName(), other.qualifiedName())));
    }

    private static Outcome run(Component configuration, Component equal, int seed) {
        Trace one = RunsAreAllowed.run(configuration, seed, SLICES);
        Trace two = RunsAreAllowed.run(equal, seed, SLICES);
        if (!shown(one).equals(shown(two))) {
            return Outcome.broken(
                    "runs differ: " + shown(one) + " and " + shown(two),
                    "simulate --main " + configuration.qualifiedName(),
                    "simulate --main " + equal.qualifiedName());
        }
        StreamTest recorded = Recorded.test(configuration, two);
        StreamTest expected = Recorded.test(equal, two);
        StreamTestResult.Verdict said = StreamTests.run(recorded).verdict();
        return said == StreamTests.run(expected).verdict()
                ? Outcome.KEPT
                : Outcome.broken(
                                "a test says " + said + " of one of them only",
                                "test " + Recorded.path(configuration))
                        .with(Recorded.path(configuration), Recorded.text(recorded));
    }

    private static List<String> shown(Trace run) {
        return run.steps().stream().map(step -> step.inputs() + " " + step.outputs()).toList();
    }
}

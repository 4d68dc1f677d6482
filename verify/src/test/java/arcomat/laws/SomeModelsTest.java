package arcomat.laws;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.laws.Law.Outcome;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.laws.naive.ByHand;
import arcomat.model.Component;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** Some laws on some hundred random models each; {@code lawTest} tries all of them on more. */
class SomeModelsTest {
    /** Nanoseconds of processor time. */
    private static final long EXPRESSIONS = 3_000_000_000L;

    @Tag("slow")
    @Test
    void aVerdictAboutAnInvariantIsThatOfTheReference() {
        Map<Answer, Integer> answers = new EnumMap<>(Answer.class);
        tried(new InvariantsAsTheReference(), 100).stream()
                .flatMap(models -> answers(models.component(Pairs.LEFT)))
                .forEach(answer -> answers.merge(answer, 1, Integer::sum));
        assertThat(answers.get(Answer.HOLDS)).isGreaterThan(24);
        assertThat(answers.get(Answer.FAILS)).isGreaterThan(24);
    }

    @Tag("slow")
    @Test
    void whatHoldsOfAnInvariantHasACertificate() {
        assertThat(tried(new CertificatesProve.OfInvariants(), 60)).hasSizeGreaterThan(10);
    }

    private static Stream<Answer> answers(Component component) {
        return component.invariants().stream()
                .map(each -> InvariantProof.check(component, List.of(), each, Questions.budget()))
                .map(verdict -> verdict.answer());
    }

    @Tag("slow")
    @Test
    void aClauseToBlameIsOneWithoutWhichItWouldFire() {
        assertThat(tried(new WhyNothingFired(), 400)).hasSizeGreaterThan(200);
    }

    @Tag("slow")
    @Test
    void aVerdictThroughAMapIsThatOfTheDefinition() {
        Map<Answer, Integer> answers = new EnumMap<>(Answer.class);
        for (Models models : tried(new MapsAsDefined(), 150)) {
            answers.merge(MapsAsDefined.verdict(models).answer(), 1, Integer::sum);
        }
        assertThat(answers.get(Answer.HOLDS)).isGreaterThan(15);
        assertThat(answers.get(Answer.FAILS)).isGreaterThan(15);
    }

    @Tag("slow")
    @Test
    void aConfigurationIsWhatIsWrittenByHand() {
        List<Models> met = tried(new ConfigurationsAsByHand(), 40);
        assertThat(met).hasSizeGreaterThan(20);
        assertThat(met)
                .anyMatch(models -> new ByHand(models.files()).pairs().size() > 6)
                .anyMatch(models -> models.model().component("more.Main").isPresent());
    }

    @Test
    void theRowOfATableThatDecidesIsTheFirstThatFits() {
        assertThat(tried(new FirstRowDecides(), 200)).hasSizeGreaterThan(120);
    }

    /** As many as there is time for: what takes long is given up, and none is an error. */
    @Tag("slow")
    @Test
    void expressionsOfTheWholeGrammarAreTaken() {
        Law law = new ExpressionsAreTaken();
        long start = processorTime();
        int met = 0;
        for (int seed = 0; processorTime() - start < EXPRESSIONS; seed++) {
            List<SourceFile> files = law.draw(new Draw(seed, EnumSet.allOf(Features.class)));
            Optional<Outcome> outcome = Trial.check(law, files, seed);
            assertThat(outcome.map(Outcome::problem).orElse("")).as(files::toString).isEmpty();
            met += outcome.map(Outcome::met).orElse(false) ? 1 : 0;
        }
        assertThat(met).isPositive();
    }

    private static long processorTime() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }

    /** Those of which the law says something. */
    private static List<Models> tried(Law law, int count) {
        List<Models> met = new ArrayList<>();
        for (int seed = 0; seed < count; seed++) {
            List<SourceFile> files = law.draw(new Draw(seed, EnumSet.allOf(Features.class)));
            Optional<Outcome> outcome = Trial.check(law, files, seed);
            assertThat(outcome.map(Outcome::problem).orElse("")).as(files::toString).isEmpty();
            if (outcome.map(Outcome::met).orElse(false)) {
                met.add(Models.read(files, seed).orElseThrow());
            }
        }
        return met;
    }
}

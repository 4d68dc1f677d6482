package arcomat.laws;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.model.Component;
import arcomat.model.Invariant;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The law about invariants on some hundred random models; {@code lawTest} tries it on more. */
class InvariantsTest {
    private static final int MODELS = 250;
    private static final int WORTH_IT = 60;

    @Test
    void aVerdictIsThatOfTheReference() {
        Law law = new InvariantsAsTheReference();
        Map<Answer, Integer> answers = new EnumMap<>(Answer.class);
        for (int seed = 0; seed < MODELS; seed++) {
            List<SourceFile> files = law.draw(new Draw(seed, EnumSet.allOf(Features.class)));
            Optional<Outcome> outcome = Trial.check(law, files, seed);
            assertThat(outcome.map(Outcome::problem).orElse("")).as(files::toString).isEmpty();
            if (outcome.isPresent()) {
                count(Models.read(files, seed).orElseThrow().component(Pairs.LEFT), answers);
            }
        }
        assertThat(answers.get(Answer.HOLDS)).isGreaterThan(WORTH_IT);
        assertThat(answers.get(Answer.FAILS)).isGreaterThan(WORTH_IT);
    }

    private static void count(Component component, Map<Answer, Integer> answers) {
        for (Invariant each : component.invariants()) {
            answers.merge(
                    InvariantProof.check(component, List.of(), each, Questions.budget()).answer(),
                    1,
                    Integer::sum);
        }
    }
}

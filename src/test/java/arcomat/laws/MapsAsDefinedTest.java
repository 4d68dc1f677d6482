package arcomat.laws;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The law about maps on some hundred random ones; {@code lawTest} tries it on more. */
class MapsAsDefinedTest {
    private static final int MODELS = 400;
    private static final int WORTH_IT = 40;

    @Test
    void aVerdictIsThatOfTheDefinition() {
        Law law = new MapsAsDefined();
        Map<Answer, Integer> answers = new EnumMap<>(Answer.class);
        for (int seed = 0; seed < MODELS; seed++) {
            List<SourceFile> files = law.draw(new Draw(seed, EnumSet.allOf(Features.class)));
            Optional<Outcome> outcome = Trial.check(law, files, seed);
            assertThat(outcome.map(Outcome::problem).orElse("")).as(files::toString).isEmpty();
            if (outcome.map(Outcome::met).orElse(false)) {
                Models models = Models.read(files, seed).orElseThrow();
                answers.merge(MapsAsDefined.verdict(models).answer(), 1, Integer::sum);
            }
        }
        assertThat(answers.get(Answer.HOLDS)).isGreaterThan(WORTH_IT);
        assertThat(answers.get(Answer.FAILS)).isGreaterThan(WORTH_IT);
    }
}

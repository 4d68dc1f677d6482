package arcomat.laws;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;

/** The law about what did not fire on some hundred random models; {@code lawTest} tries more. */
class WhyNothingFiredTest {
    private static final int MODELS = 400;
    private static final int WORTH_IT = 200;

    @Test
    void aClauseToBlameIsOneWithoutWhichItWouldFire() {
        Law law = new WhyNothingFired();
        int met = 0;
        for (int seed = 0; seed < MODELS; seed++) {
            List<SourceFile> files = law.draw(new Draw(seed, EnumSet.allOf(Features.class)));
            Optional<Outcome> outcome = Trial.check(law, files, seed);
            assertThat(outcome.map(Outcome::problem).orElse("")).as(files::toString).isEmpty();
            met += outcome.map(Outcome::met).orElse(false) ? 1 : 0;
        }
        assertThat(met).isGreaterThan(WORTH_IT);
    }
}

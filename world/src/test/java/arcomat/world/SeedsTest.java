package arcomat.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SeedsTest {
    @ParameterizedTest
    @ValueSource(strings = {"5", "-5", "5@12.5=77", "5@0=1@0.01=-2@100=3"})
    void whatIsWrittenIsRead(String text) {
        assertThat(Seeds.parse(text).text()).isEqualTo(text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "x", "5@", "5@1", "5@1=", "5@2=1@1=1", "5@-1=1", "5@0.0001=1"})
    void somethingElseIsNotRead(String text) {
        assertThatThrownBy(() -> Seeds.parse(text)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void whoBeginsAfreshForgetsWhatWasToCome() {
        Seeds seeds = Seeds.of(1).then(100, 2).then(200, 3);
        assertThat(seeds.afresh(300, 4)).isEqualTo(seeds.then(300, 4));
        assertThat(seeds.afresh(200, 4)).isEqualTo(Seeds.of(1).then(100, 2).then(200, 4));
        assertThat(seeds.afresh(150, 4)).isEqualTo(Seeds.of(1).then(100, 2).then(150, 4));
        assertThat(seeds.afresh(0, 4)).isEqualTo(Seeds.of(1).then(0, 4));
    }
}

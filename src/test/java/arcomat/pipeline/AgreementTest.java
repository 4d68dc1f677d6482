package arcomat.pipeline;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.SampleComponents;
import arcomat.model.Value;

import org.junit.jupiter.api.Test;

import java.util.List;

/** Interpreter and compiled code give the same traces: outputs, states, transitions, errors. */
class AgreementTest {
    @Test
    void onTheThirdVersionOfAvoidCrash() {
        Agreement agreement = new Agreement(SampleComponents.avoidCrash(), List.of());
        assertThat(agreement.holds(100, 50).transitionsTaken()).hasSize(6);
    }

    @Test
    void onAnAutomatonWithAChoice() {
        Agreement agreement = new Agreement(SampleComponents.undecided(), List.of());
        assertThat(agreement.holds(100, 50).transitionsTaken()).hasSize(3);
    }

    @Test
    void onErrorsOfTheModel() {
        List<Value> slices = List.of(new Value.IntegerValue(5));
        Agreement agreement = new Agreement(SampleComponents.timer(), slices);
        assertThat(agreement.holds(200, 50).transitionsTaken()).hasSizeGreaterThan(2);
    }

    @Test
    void onANetworkWithPlatformComponents() {
        Agreement agreement = new Agreement(SampleComponents.whole(), List.of());
        assertThat(agreement.holds(200, 50).transitionsTaken()).hasSizeGreaterThan(8);
    }
}

package arcomat.benchmarks.step;

import com.github.oxo42.stateless4j.StateMachine;
import com.github.oxo42.stateless4j.StateMachineConfig;

final class StatelessMachine extends LibraryMachine {
    private final StateMachine<Integer, Integer> machine;

    StatelessMachine() {
        StateMachineConfig<Integer, Integer> config = new StateMachineConfig<>();
        for (Rule rule : Rule.all()) {
            config.configure(rule.source()).permit(rule.letter(), rule.target(), () -> send(rule));
        }
        machine = new StateMachine<>(IntSwitch.DRIVING, config);
        machine.onUnhandledTrigger((state, letter) -> {});
    }

    @Override
    protected void fire(int letter) {
        machine.fire(letter);
    }
}

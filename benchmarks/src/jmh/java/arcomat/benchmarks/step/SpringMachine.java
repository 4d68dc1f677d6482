package arcomat.benchmarks.step;

import org.springframework.messaging.support.MessageBuilder;
import org.springframework.statemachine.StateMachine;
import org.springframework.statemachine.config.StateMachineBuilder;

import reactor.core.publisher.Mono;

import java.util.Set;

final class SpringMachine extends LibraryMachine {
    private final StateMachine<Integer, Integer> machine;

    SpringMachine() {
        StateMachineBuilder.Builder<Integer, Integer> builder = StateMachineBuilder.builder();
        try {
            builder.configureStates()
                    .withStates()
                    .initial(IntSwitch.DRIVING)
                    .states(Set.of(0, 1, 2, 3, 4));
            for (Rule rule : Rule.all()) {
                builder.configureTransitions()
                        .withExternal()
                        .source(rule.source())
                        .target(rule.target())
                        .event(rule.letter())
                        .action(context -> send(rule));
            }
        } catch (Exception wrongConfiguration) {
            throw new IllegalStateException(wrongConfiguration);
        }
        machine = builder.build();
        machine.startReactively().block();
    }

    @Override
    protected void fire(int letter) {
        machine.sendEvent(Mono.just(MessageBuilder.withPayload(letter).build())).blockLast();
    }
}

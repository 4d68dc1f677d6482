package arcomat.benchmarks.step;

import org.squirrelframework.foundation.fsm.AnonymousAction;
import org.squirrelframework.foundation.fsm.StateMachineBuilder;
import org.squirrelframework.foundation.fsm.StateMachineBuilderFactory;
import org.squirrelframework.foundation.fsm.impl.AbstractStateMachine;

final class SquirrelMachine extends LibraryMachine {
    /** The library wants a class of its own for each kind of machine. */
    static class Machine extends AbstractStateMachine<Machine, Integer, Integer, SquirrelMachine> {}

    private final Machine machine;

    SquirrelMachine() {
        StateMachineBuilder<Machine, Integer, Integer, SquirrelMachine> builder =
                StateMachineBuilderFactory.create(
                        Machine.class, Integer.class, Integer.class, SquirrelMachine.class);
        for (Rule rule : Rule.all()) {
            builder.externalTransition()
                    .from(rule.source())
                    .to(rule.target())
                    .on(rule.letter())
                    .perform(sending(rule));
        }
        machine = builder.newStateMachine(IntSwitch.DRIVING);
        machine.start(this);
    }

    private static AnonymousAction<Machine, Integer, Integer, SquirrelMachine> sending(Rule rule) {
        return new AnonymousAction<>() {
            @Override
            public void execute(
                    Integer from, Integer to, Integer event, SquirrelMachine owner, Machine self) {
                owner.send(rule);
            }
        };
    }

    @Override
    protected void fire(int letter) {
        machine.fire(letter, this);
    }
}

package arcomat.simulate.run;

import arcomat.model.Port;
import arcomat.model.Value;

import java.util.Optional;

/** Draws with the generator that generated code uses, in the same order. */
final class RandomChoice implements Choice {
    private final arcomat.rt.Choice generator;
    private final boolean drawsMessages;

    RandomChoice(int seed, boolean drawsMessages) {
        this.generator = new arcomat.rt.Choice(seed);
        this.drawsMessages = drawsMessages;
    }

    @Override
    public int pick(Question question) {
        return generator.next(question.count());
    }

    @Override
    public Optional<Value> message(Port port, boolean required) {
        if (!drawsMessages) {
            return Choice.super.message(port, required);
        }
        return required || generator.next(2) == 0
                ? Optional.of(RandomValues.draw(port.type(), generator))
                : Optional.empty();
    }
}

package arcomat.simulate.run;

import arcomat.model.Port;
import arcomat.model.Value;

import java.util.Optional;

/** Asks for the alternative; open messages are those of {@link FirstChoice}. */
final class AskedChoice implements Choice {
    private final Asker asker;

    AskedChoice(Asker asker) {
        this.asker = asker;
    }

    @Override
    public int pick(Question question) {
        int answer = asker.ask(question);
        if (answer < 0 || answer >= question.count()) {
            throw new IllegalArgumentException(
                    "there are " + question.count() + " alternatives, " + answer + " is none");
        }
        return answer;
    }

    @Override
    public Optional<Value> message(Port port, boolean required) {
        return Choice.first().message(port, required);
    }
}

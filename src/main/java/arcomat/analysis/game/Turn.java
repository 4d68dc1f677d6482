package arcomat.analysis.game;

import arcomat.analysis.search.product.Comparison.Allowed;
import arcomat.model.Letter;
import arcomat.semantics.expression.Sent;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What the environment sends in one position of a game that it wins, and what the system can answer
 * without breaking a requirement at once.
 *
 * @param input nothing for the first turn, in which the system sends its initial outputs
 * @param answers none where the requirements contradict each other
 * @param demands what each requirement allows; only where there are no answers
 */
public record Turn(Letter input, List<Answer> answers, List<Demand> demands) {
    public Turn {
        answers = List.copyOf(answers);
        demands = List.copyOf(demands);
    }

    /**
     * @param outputs by port; what is left open is no {@link Sent.Messages}
     * @param next number of the turn that follows
     */
    public record Answer(Map<String, Sent> outputs, int next) {
        public Answer {
            outputs = Collections.unmodifiableMap(new LinkedHashMap<>(outputs));
        }
    }

    /**
     * @param requirement its position among those of the game
     */
    public record Demand(int requirement, List<Allowed> allowed) {
        public Demand {
            allowed = List.copyOf(allowed);
        }
    }
}

package arcomat.analysis.game;

import arcomat.analysis.game.controller.MealyMachine;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Numbering;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.GivenUp;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.MessageClasses;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What a system does that wins, a strategy without memory of its own: in every position the first
 * output that leads to no lost position. Games about different outputs are played at once, each on
 * its own.
 */
public final class Synthesis {
    private static final int MOST_STATES = 10_000;
    private static final long MOST_LETTERS = 100_000;

    private final List<Game> games;
    private final Budget budget;
    private final List<Port> inputs;
    private final List<Port> outputs;
    private final Numbering<List<Integer>> states = new Numbering<>();

    private Synthesis(List<Game> games, Budget budget) {
        this.games = games;
        this.budget = budget;
        this.inputs = games.get(0).arena().inputs();
        this.outputs = games.get(0).arena().outputs();
    }

    /**
     * @param games at least one, each won by the system, and explored unless no position is lost
     * @return empty where the machine is too large, or time or memory is used up
     */
    public static Optional<MealyMachine> of(List<Game> games, Budget budget) {
        try {
            return new Synthesis(games, budget).machine();
        } catch (GivenUp inTheMiddle) {
            return Optional.empty();
        }
    }

    private Optional<MealyMachine> machine() {
        List<Arena.Option> openings = new ArrayList<>();
        games.forEach(game -> openings.add(best(game, game.arena().openings())));
        number(openings);
        List<MealyMachine.State> all = new ArrayList<>();
        for (int i = 0; i < states.size(); i++) {
            boolean tooMany = i == MOST_STATES || budget.exhausted(i) != null;
            Optional<MealyMachine.State> state = tooMany ? Optional.empty() : state(states.get(i));
            if (state.isEmpty()) {
                return Optional.empty();
            }
            all.add(state.get());
        }
        return Optional.of(new MealyMachine(inputs, outputs, sent(openings), all));
    }

    /** Better not to err; where it cannot be avoided for ever, later is better than now. */
    private static Arena.Option best(Game game, List<Arena.Option> options) {
        List<Arena.Option> safe =
                options.stream().filter(option -> !game.isLost(option.position())).toList();
        return safe.stream()
                .filter(option -> !game.errs(option.position()))
                .findFirst()
                .orElseGet(() -> safe.get(0));
    }

    private int number(List<Arena.Option> options) {
        return states.number(options.stream().map(Arena.Option::position).toList());
    }

    private Optional<MealyMachine.State> state(List<Integer> positions) {
        List<PortAbstraction> looks = looks(positions);
        List<List<Value>> samples = new ArrayList<>();
        long letters = 1;
        for (int port = 0; port < inputs.size(); port++) {
            Port input = inputs.get(port);
            samples.add(MessageClasses.of(input, input.total(), looks.get(port)).samples());
            letters *= samples.get(port).size();
            if (letters > MOST_LETTERS) {
                return Optional.empty();
            }
        }
        List<MealyMachine.Reaction> reactions = new ArrayList<>();
        react(positions, samples, new Value[inputs.size()], 0, reactions);
        return Optional.of(new MealyMachine.State(name(positions), looks, samples, reactions));
    }

    private String name(List<Integer> positions) {
        List<String> names = new ArrayList<>();
        for (int i = 0; i < games.size(); i++) {
            names.addAll(games.get(i).arena().states(positions.get(i)));
        }
        boolean free = positions.stream().allMatch(position -> position == Arena.FREE);
        return free ? "free" : String.join("_", names);
    }

    private List<PortAbstraction> looks(List<Integer> positions) {
        InputAbstraction all = InputAbstraction.none(inputs.size());
        for (int i = 0; i < games.size(); i++) {
            all = all.and(games.get(i).arena().abstraction(positions.get(i)));
        }
        return all.looks();
    }

    private void react(
            List<Integer> positions,
            List<List<Value>> samples,
            Value[] letter,
            int port,
            List<MealyMachine.Reaction> reactions) {
        if (port == inputs.size()) {
            reactions.add(reaction(positions, letter.clone()));
            return;
        }
        for (Value sample : samples.get(port)) {
            letter[port] = sample;
            react(positions, samples, letter, port + 1, reactions);
        }
    }

    private MealyMachine.Reaction reaction(List<Integer> positions, Value[] letter) {
        List<Arena.Option> moves = new ArrayList<>();
        for (int i = 0; i < games.size(); i++) {
            Game game = games.get(i);
            int position = positions.get(i);
            moves.add(
                    position == Arena.FREE
                            ? new Arena.Option(Output.anything(outputs.size()), Arena.FREE)
                            : best(game, game.arena().options(position, letter)));
        }
        return moves.stream().anyMatch(move -> move.sent() == null)
                ? new MealyMachine.Reaction(null, 0)
                : new MealyMachine.Reaction(sent(moves), number(moves));
    }

    /**
     * What all moves allow; silence where they leave that open, on a port that may be silent.
     * Before anything is read nothing is sent without delay: no move leaves that open.
     */
    private Output sent(List<Arena.Option> moves) {
        Output all = Output.anything(outputs.size());
        for (Arena.Option move : moves) {
            all = all.meet(Objects.requireNonNull(move.sent())).orElseThrow();
        }
        List<Sent> letter = new ArrayList<>();
        for (int i = 0; i < outputs.size(); i++) {
            Port port = outputs.get(i);
            Sent sent = all.ports().get(i);
            if (sent instanceof Sent.AnyMessage || sent instanceof Sent.Anything && port.total()) {
                sent = new Sent.Messages(Collections.singletonList(port.type().first()));
            }
            letter.add(sent instanceof Sent.Anything ? Sent.SILENCE : sent);
        }
        return new Output(letter);
    }
}

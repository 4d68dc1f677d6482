package arcomat.analysis.game;

import arcomat.analysis.game.Requirement.Reply;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.product.Counterexample.Allowed;
import arcomat.analysis.search.step.Steps;
import arcomat.model.Letter;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * How the environment wins a game, turn by turn: with a single word if there is one, else by
 * answering what the system does (Könighofer, Hofferek, Bloem, "Debugging formal specifications
 * using simple counterstrategies", FMCAD 2009).
 */
public final class CounterStrategy {
    private static final int BEGINNING = -1;

    /**
     * @param turns the first one is the beginning; answers refer to the others by number
     * @param word the inputs, where one word works whatever the system answers
     * @param decided whether there is no such word if none was found
     */
    public record Won(List<Turn> turns, Optional<List<Letter>> word, boolean decided) {}

    /**
     * What the environment sends in one position of a game that it wins, and what the system can
     * answer without breaking a requirement at once.
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

    /** Where a turn is played: after so many letters of the word, or anywhere; and the position. */
    private record Place(int letters, int position) {}

    private final Arena arena;
    private final boolean blind;
    private final Function<Place, Value[]> inputs;
    private final Numbering<Place> places = new Numbering<>();

    /**
     * @param blind whether only the letters before a place matter
     * @param inputs what the environment sends
     */
    private CounterStrategy(Arena arena, boolean blind, Function<Place, Value[]> inputs) {
        this.arena = arena;
        this.blind = blind;
        this.inputs = inputs;
    }

    private static CounterStrategy of(Arena arena, List<Value[]> word) {
        return new CounterStrategy(arena, true, place -> word.get(place.letters));
    }

    private static CounterStrategy of(Arena arena, AttractorRanks strategy) {
        return new CounterStrategy(
                arena,
                false,
                place -> arena.alphabet(place.position).letter(strategy.letter(place.position)));
    }

    /** Tells a game that the environment wins. */
    public static Won of(Game game, Budget budget) {
        int[] openings =
                game.arena().openings().stream().mapToInt(Arena.Option::position).toArray();
        int shortest = game.ranks().of(openings);
        game.playOn(shortest);
        AttractorRanks ranks = game.ranks();
        BlindStrategy.Found found = new BlindStrategy(game, ranks, shortest, budget).search();
        if (found.word().isEmpty()) {
            game.playOn(AttractorRanks.NEVER);
            found = new BlindStrategy(game, ranks, AttractorRanks.NEVER, budget).search();
        }
        CounterStrategy telling =
                found.word().isPresent()
                        ? of(game.arena(), found.word().get())
                        : of(game.arena(), ranks);
        return new Won(telling.turns(), found.word().map(telling::letters), found.decided());
    }

    private List<Letter> letters(List<Value[]> inputs) {
        return inputs.stream().map(this::letter).toList();
    }

    private List<Turn> turns() {
        places.number(new Place(0, BEGINNING));
        List<Turn> turns = new ArrayList<>();
        for (int i = 0; i < places.size(); i++) {
            turns.add(turn(places.get(i)));
        }
        return turns;
    }

    private Turn turn(Place place) {
        boolean beginning = place.position == BEGINNING;
        Value[] input = beginning ? new Value[arena.inputs().size()] : inputs.apply(place);
        List<Arena.Option> options =
                beginning ? arena.openings() : arena.options(place.position, input);
        List<Turn.Answer> answers = new ArrayList<>();
        int letters = beginning || !blind ? 0 : place.letters + 1;
        for (Arena.Option option : options) {
            int next = places.number(new Place(letters, option.position()));
            answers.add(new Turn.Answer(named(option.sent()), next));
        }
        return new Turn(
                letter(input), answers, answers.isEmpty() ? demands(place, input) : List.of());
    }

    private List<Turn.Demand> demands(Place place, Value[] input) {
        List<Turn.Demand> demands = new ArrayList<>();
        for (int i = 0; i < arena.requirements().size(); i++) {
            Requirement requirement = arena.requirements().get(i);
            Reply reply =
                    place.position == BEGINNING
                            ? requirement.opening()
                            : arena.replies(place.position, input)[i];
            if (reply != null) {
                demands.add(new Turn.Demand(i, allowed(requirement, reply)));
            }
        }
        return demands;
    }

    private List<Allowed> allowed(Requirement requirement, Reply reply) {
        List<Allowed> allowed = new ArrayList<>();
        for (Requirement.Part part : reply.before()) {
            Steps steps = part.steps();
            for (int step = 0; step < steps.size(); step++) {
                allowed.add(
                        new Allowed(
                                part.configuration() < 0
                                        ? ""
                                        : requirement.system().describe(part.configuration()),
                                steps.causes().get(step),
                                named(requirement.sent(steps.outputs()[step])),
                                requirement.sent(steps.outputs()[step]) == null));
            }
        }
        return allowed;
    }

    private Map<String, Sent> named(@Nullable Output output) {
        Map<String, Sent> named = new LinkedHashMap<>();
        for (int i = 0; output != null && i < arena.outputs().size(); i++) {
            named.put(arena.outputs().get(i).name(), output.ports().get(i));
        }
        return named;
    }

    private Letter letter(Value[] messages) {
        return Letter.of(arena.inputs(), messages);
    }
}

package arcomat.analysis.mona;

import arcomat.analysis.mona.ExplicitSystem.Step;
import arcomat.analysis.search.Moment;
import arcomat.analysis.search.product.Counterexample.Allowed;
import arcomat.analysis.search.product.Counterexample.Forbidden;
import arcomat.model.Letter;
import arcomat.model.Value;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Tells a counterexample of MONA's as a run of the models: the left side takes every step of it,
 * and one automaton of the right side does not take the last.
 */
public final class Replay {

    /**
     * What the counterexample shows.
     *
     * @param right position of the automaton of the right side that forbids it
     */
    public record Shown(int right, List<Moment> moments, Forbidden forbidden) {}

    private final InclusionProblem question;
    private final Map<String, String> rows;
    private final int length;
    private final Bits leftBits;

    /**
     * @param rows per bit one character for each position: 0, 1, or X where it does not matter
     */
    public Replay(InclusionProblem question, Map<String, String> rows) {
        this.question = question;
        this.rows = rows;
        this.leftBits = question.left().stateBits("left");
        this.length = rows.values().stream().mapToInt(String::length).min().orElse(0);
    }

    /**
     * @return empty where it is no run of the left side, or one that the right side allows: then
     *     the program and this one disagree
     */
    public Optional<Shown> run() {
        for (int right = 0; right < question.rights().size(); right++) {
            Optional<Shown> shown = run(right);
            if (shown.isPresent()) {
                return shown;
            }
        }
        return Optional.empty();
    }

    private Optional<Shown> run(int right) {
        ExplicitSystem theirs = question.rights().get(right);
        List<Moment> moments = new ArrayList<>();
        Set<Integer> after = Set.of();
        for (int slice = 0; slice < length; slice++) {
            Optional<Step> mine = mine(slice);
            if (mine.isEmpty()) {
                return Optional.empty();
            }
            Set<Integer> before = after;
            after = after(theirs, before, slice, mine.get().error());
            moments.add(moment(mine.get(), theirs, after, slice));
            if (after.isEmpty()) {
                return Optional.of(
                        new Shown(right, moments, forbidden(mine.get(), theirs, before, slice)));
            }
        }
        return Optional.empty();
    }

    /** The step of the left side whose reaction is seen in a slice; first an opening. */
    private Optional<Step> mine(int slice) {
        List<Step> steps =
                slice == 0
                        ? question.left().openings()
                        : state(slice - 1) < question.left().states().size()
                                ? question.left().states().get(state(slice - 1)).steps()
                                : List.of();
        return steps.stream()
                .filter(step -> step.next() == state(slice) && step.error() == isError(slice))
                .filter(step -> slice == 0 || reads(step, question.left(), slice))
                .filter(step -> shows(step, slice))
                .findFirst();
    }

    private int state(int slice) {
        return number(leftBits, slice);
    }

    private boolean isError(int slice) {
        String row = rows.get(SystemWriter.FAILS);
        return row != null && row.charAt(slice) == '1';
    }

    private int number(Bits bits, int slice) {
        int number = 0;
        for (int bit = 0; bit < bits.names().size(); bit++) {
            String row = rows.get(bits.names().get(bit));
            number |= row != null && row.charAt(slice) == '1' ? 1 << bit : 0;
        }
        return number;
    }

    /** Whether a step belongs to the input before a slice. */
    private boolean reads(Step step, ExplicitSystem system, int slice) {
        return IntStream.range(0, step.inputs().size())
                .allMatch(
                        port -> {
                            int code = number(system.inputs().get(port).bits(), slice - 1);
                            return step.inputs().get(port).contains(code);
                        });
    }

    /** Where the run ends, what earlier reactions show counts, where one side has any. */
    private boolean shows(Step step, int slice) {
        IntStream ports =
                step.error()
                        ? question.mixed().stream()
                        : IntStream.range(0, question.observed().size());
        return ports.allMatch(
                port -> {
                    Sent sent = step.sent() == null ? Sent.SILENCE : step.sent().ports().get(port);
                    return sent.allows(seen(port, slice).values());
                });
    }

    /** What is seen of the reaction: with delay 0 in the slice before. */
    private Sent.Messages seen(int port, int slice) {
        PortTrack track = question.observed().get(port);
        int position = slice - 1 + question.delays().get(port);
        Optional<Value> message =
                position < 0 ? Optional.empty() : track.message(number(track.bits(), position));
        return new Sent.Messages(message.map(List::of).orElse(List.of()));
    }

    private Set<Integer> after(
            ExplicitSystem theirs, Set<Integer> before, int slice, boolean error) {
        Set<Integer> after = new LinkedHashSet<>();
        if (slice == 0) {
            theirs.openings().stream()
                    .filter(opening -> shows(opening, slice))
                    .forEach(opening -> after.add(opening.next()));
        }
        for (int state : before) {
            if (theirs.states().get(state).chaos()) {
                if (!error) {
                    after.add(state);
                }
                continue;
            }
            for (Step step : theirs.states().get(state).steps()) {
                if (step.error() == error && reads(step, theirs, slice) && shows(step, slice)) {
                    after.add(step.next());
                }
            }
        }
        return after;
    }

    private Moment moment(Step mine, ExplicitSystem theirs, Set<Integer> after, int slice) {
        return new Moment(
                letter(slice),
                sent(mine, slice),
                question.left().states().get(mine.next()).name(),
                after.stream().map(state -> theirs.states().get(state).name()).toList(),
                mine.error());
    }

    /** The input before a slice. */
    private Letter letter(int slice) {
        Map<String, Value> messages = new LinkedHashMap<>();
        if (slice > 0) {
            for (PortTrack track : question.inputs()) {
                track.message(number(track.bits(), slice - 1))
                        .ifPresent(message -> messages.put(track.port().name(), message));
            }
        }
        return Letter.of(messages);
    }

    /** On compared ports what was seen; on others what the left side sends there. */
    private Map<String, Sent> sent(Step mine, int slice) {
        Map<String, Sent> sent = new LinkedHashMap<>();
        if (mine.error()) {
            question.mixed().stream()
                    .filter(port -> !seen(port, slice).equals(Sent.SILENCE))
                    .forEach(port -> sent.put(name(port), seen(port, slice)));
            return sent;
        }
        for (int i = 0; i < question.leftOutputs().size(); i++) {
            sent.put(question.leftOutputs().get(i).name(), mine.whole().ports().get(i));
        }
        for (int port = 0; port < question.observed().size(); port++) {
            sent.put(name(port), seen(port, slice));
        }
        return sent;
    }

    private String name(int port) {
        return question.observed().get(port).port().name();
    }

    private Forbidden forbidden(Step mine, ExplicitSystem theirs, Set<Integer> before, int slice) {
        List<Allowed> allowed = new ArrayList<>();
        if (slice == 0) {
            theirs.openings().forEach(opening -> allowed.add(allowed("", opening)));
        }
        for (int state : before) {
            for (Step step : theirs.states().get(state).steps()) {
                if (reads(step, theirs, slice)) {
                    allowed.add(allowed(theirs.states().get(state).name(), step));
                }
            }
        }
        return new Forbidden(
                mine.causes(),
                sent(mine, slice),
                mine.error() ? Optional.of("error") : Optional.empty(),
                slice == 0 ? "" : question.left().states().get(state(slice - 1)).name(),
                allowed);
    }

    private Allowed allowed(String before, Step step) {
        Map<String, Sent> sent = new LinkedHashMap<>();
        for (int i = 0; !step.error() && i < question.observed().size(); i++) {
            sent.put(name(i), Objects.requireNonNull(step.sent()).ports().get(i));
        }
        return new Allowed(before, step.causes(), sent, step.error());
    }
}

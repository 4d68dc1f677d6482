package arcomat.analysis.coverage;

import arcomat.analysis.search.letter.Letters;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.value.InputAbstraction.Compared;
import arcomat.semantics.value.InputAbstraction.Copied;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.InputAbstraction.Unseen;
import arcomat.semantics.value.InputAbstraction.Whole;
import arcomat.semantics.value.SmallType;
import arcomat.semantics.value.TooManyMessages;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;

/**
 * What an atomic component can be given in a configuration, one of each kind that its transitions
 * tell apart. Where these are too many, or cannot be told, each transition is given what it alone
 * tells apart; where every value of a port matters, those are tried that the model mentions, and
 * some beside them.
 */
final class Stimuli {

    /**
     * A letter of the time-synchronous profile or an event of the other.
     *
     * @param input what the automata read; empty where only a latched port changes
     * @param latched the latched values afterwards, by input port; null where there is none
     */
    record Stimulus(Letter letter, Optional<Input> input, List<Value> latched) {}

    /** So many letters are tried in one configuration, or for one transition. */
    private static final int MOST_LETTERS = 4096;

    /** So many values of each of several ports can be combined. */
    private static final int FEW = 16;

    private final ComponentSemantics behaviour;
    private final List<Port> ports;
    private final boolean timed;
    private final MentionedValues mentions;
    private final CalculatedLetters calculated;
    private @Nullable String sampled;

    /**
     * @param stop asked now and then, whether to give up
     */
    Stimuli(ComponentSemantics behaviour, List<Value> arguments, BooleanSupplier stop) {
        this.behaviour = behaviour;
        this.ports = behaviour.component().inputs();
        this.timed = behaviour.component().profile() == Component.Profile.TIME_SYNCHRONOUS;
        this.mentions = MentionedValues.of(behaviour.component(), arguments);
        this.calculated = new CalculatedLetters(behaviour, stop);
    }

    /** What has not been tried, where that is something. */
    Optional<String> sampled() {
        return Optional.ofNullable(sampled);
    }

    /**
     * @param latched as in {@link Stimulus}
     */
    List<Stimulus> of(List<Configuration> configurations, List<Value> latched) {
        PortAbstraction[] looks =
                behaviour.abstraction(configurations).looks().toArray(PortAbstraction[]::new);
        return timed ? letters(looks, configurations, latched) : events(looks, latched);
    }

    private PortAbstraction[] unseen() {
        PortAbstraction[] looks = new PortAbstraction[ports.size()];
        Arrays.fill(looks, new Unseen());
        return looks;
    }

    private List<Stimulus> letters(
            PortAbstraction[] looks, List<Configuration> configurations, List<Value> latched) {
        Set<List<Value>> letters = new LinkedHashSet<>();
        try {
            add(looks, letters);
        } catch (TooManyMessages problem) {
            calculated
                    .of(configurations, MOST_LETTERS)
                    .ifPresentOrElse(
                            all -> all.forEach(letter -> letters.add(Arrays.asList(letter))),
                            () -> addByTransition(looks, configurations, letters));
        }
        List<Stimulus> stimuli = new ArrayList<>();
        for (List<Value> letter : letters) {
            Value[] messages = letter.toArray(new Value[0]);
            stimuli.add(
                    new Stimulus(
                            Letter.of(ports, messages), Optional.of(Input.of(messages)), latched));
        }
        return stimuli;
    }

    private void addByTransition(
            PortAbstraction[] looks, List<Configuration> configurations, Set<List<Value>> letters) {
        for (MentionedValues transition : transitions(configurations)) {
            addSome(only(transition, looks), letters);
        }
    }

    /** What the transitions out of a configuration look at, each by itself. */
    private List<MentionedValues> transitions(List<Configuration> configurations) {
        List<MentionedValues> mentioned = new ArrayList<>();
        for (int i = 0; i < configurations.size(); i++) {
            Automaton automaton = behaviour.relations().get(i).automaton();
            for (Automaton.Transition transition : automaton.transitions()) {
                if (transition.source() == configurations.get(i).state()) {
                    mentioned.add(MentionedValues.of(transition));
                }
            }
        }
        if (configurations.size() > 1) {
            sampled = "only some combinations of messages were tried";
        }
        return mentioned;
    }

    private PortAbstraction[] only(MentionedValues transition, PortAbstraction[] looks) {
        PortAbstraction[] own = unseen();
        for (int i = 0; i < own.length; i++) {
            own[i] = transition.port(ports.get(i).name()) ? looks[i] : own[i];
        }
        return own;
    }

    private List<Stimulus> events(PortAbstraction[] looks, List<Value> latched) {
        List<Stimulus> stimuli = new ArrayList<>();
        for (int port = 0; port < looks.length; port++) {
            PortAbstraction[] alone = unseen();
            alone[port] = looks[port];
            Set<List<Value>> letters = new LinkedHashSet<>();
            addSome(alone, letters);
            for (List<Value> messages : letters) {
                if (messages.get(port) != null) {
                    stimuli.add(event(port, messages.get(port), latched));
                }
            }
        }
        return stimuli;
    }

    private Stimulus event(int port, Value message, List<Value> latched) {
        Letter letter = Letter.of(Map.of(ports.get(port).name(), message));
        Value[] messages = latched.toArray(new Value[0]);
        messages[port] = message;
        return ports.get(port).latched()
                ? new Stimulus(letter, Optional.empty(), Arrays.asList(messages))
                : new Stimulus(letter, Optional.of(Input.of(messages)), latched);
    }

    /**
     * @throws TooManyMessages where there are too many to try
     */
    private void add(PortAbstraction[] looks, Set<List<Value>> letters) {
        for (Value[] letter : Letters.atMost(MOST_LETTERS, ports, List.of(looks))) {
            letters.add(Arrays.asList(letter));
        }
    }

    private void addSome(PortAbstraction[] looks, Set<List<Value>> letters) {
        try {
            add(looks, letters);
        } catch (TooManyMessages tooMany) {
            try {
                add(fewer(looks), letters);
            } catch (TooManyMessages still) {
                sampled = String.valueOf(still.getMessage());
            }
        }
    }

    private PortAbstraction[] fewer(PortAbstraction[] looks) {
        PortAbstraction[] fewer = looks.clone();
        for (int i = 0; i < looks.length; i++) {
            if ((looks[i] instanceof Whole || looks[i] instanceof Copied)
                    && !isSmall(ports.get(i).type())) {
                fewer[i] = sample(ports.get(i));
            }
        }
        return fewer;
    }

    private static boolean isSmall(Type type) {
        return type instanceof Type.EnumType
                || SmallType.values(type).filter(all -> all.size() <= FEW).isPresent();
    }

    private PortAbstraction sample(Port port) {
        Type type = port.type();
        sampled =
                "only some values of port '%s' were tried, %s has too many"
                        .formatted(port.name(), type.name());
        boolean number = type instanceof Type.IntegerType || type instanceof Type.RealType;
        List<Value> some = mentions.of(type).stream().limit(FEW).toList();
        return new Compared(some, number);
    }
}

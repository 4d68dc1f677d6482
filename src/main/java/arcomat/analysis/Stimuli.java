package arcomat.analysis;

import arcomat.analysis.engine.Alphabet;
import arcomat.analysis.engine.TooManyMessages;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.Attention;
import arcomat.semantics.Attention.Compared;
import arcomat.semantics.Attention.Look;
import arcomat.semantics.Attention.Unseen;
import arcomat.semantics.Attention.Whole;
import arcomat.semantics.Behaviour;
import arcomat.semantics.Configuration;
import arcomat.semantics.Input;
import arcomat.semantics.Rewriting;
import arcomat.semantics.StepRelation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What an atomic component can be given in a configuration, one of each kind that its transitions
 * tell apart. Where every value of a port matters and there are too many, those are tried that the
 * model mentions, and some beside them.
 */
final class Stimuli {

    /**
     * A letter of the time-synchronous profile or an event of the other.
     *
     * @param input what the automata read; empty where only a latched port changes
     * @param latched the latched values afterwards, by input port; null where there is none
     */
    record Stimulus(Letter letter, Optional<Input> input, List<Value> latched) {}

    /** So many values of each of several ports can be combined. */
    private static final int FEW = 64;

    private final Behaviour behaviour;
    private final List<Port> ports;
    private final boolean timed;
    private final Set<Value> mentioned = new LinkedHashSet<>();
    private String sampled;

    Stimuli(Behaviour behaviour, List<Value> arguments) {
        this.behaviour = behaviour;
        this.ports = behaviour.component().inputs();
        this.timed = behaviour.component().profile() == Component.Profile.TIME_SYNCHRONOUS;
        mentioned.addAll(arguments);
        behaviour.component().constants().forEach(constant -> mention(constant.initial()));
        behaviour.relations().forEach(relation -> mention(relation.automaton()));
    }

    private void mention(Automaton automaton) {
        for (Automaton.Transition transition : automaton.transitions()) {
            transition.guard().ifPresent(this::mention);
            for (Automaton.Match match : transition.matches()) {
                if (match.pattern() instanceof Automaton.OneOf oneOf) {
                    oneOf.values().forEach(this::mention);
                }
            }
            for (Automaton.Send send : transition.sends()) {
                if (send.emission() instanceof Automaton.Messages messages) {
                    messages.values().forEach(this::mention);
                }
            }
            transition.assignments().forEach(assignment -> mention(assignment.value()));
        }
    }

    private void mention(Expression expression) {
        Rewriting.visit(
                expression,
                e -> {
                    if (e instanceof Expression.Constant constant) {
                        mentioned.add(constant.value());
                    }
                });
    }

    /** Which port has not been tried with all its values, where there is one. */
    Optional<String> sampled() {
        return Optional.ofNullable(sampled);
    }

    /**
     * @param latched as in {@link Stimulus}
     */
    List<Stimulus> of(List<Configuration> configurations, List<Value> latched) {
        Look[] looks = looks(configurations);
        return timed ? letters(looks, latched) : events(looks, latched);
    }

    private Look[] looks(List<Configuration> configurations) {
        Look[] looks = new Look[ports.size()];
        Arrays.fill(looks, new Unseen());
        for (int i = 0; i < configurations.size(); i++) {
            StepRelation relation = behaviour.relations().get(i);
            List<Look> own = relation.attention(configurations.get(i)).looks();
            for (int port = 0; port < looks.length; port++) {
                looks[port] = looks[port].and(own.get(port));
            }
        }
        return looks;
    }

    private List<Stimulus> letters(Look[] looks, List<Value> latched) {
        List<Stimulus> stimuli = new ArrayList<>();
        for (Value[] messages : alphabet(looks)) {
            Map<String, Value> letter = new LinkedHashMap<>();
            for (int i = 0; i < messages.length; i++) {
                if (messages[i] != null) {
                    letter.put(ports.get(i).name(), messages[i]);
                }
            }
            Optional<Input> input = Optional.of(Input.of(messages));
            stimuli.add(new Stimulus(Letter.of(letter), input, latched));
        }
        return stimuli;
    }

    private List<Stimulus> events(Look[] looks, List<Value> latched) {
        List<Stimulus> stimuli = new ArrayList<>();
        for (int port = 0; port < looks.length; port++) {
            Look[] alone = new Look[looks.length];
            Arrays.fill(alone, new Unseen());
            alone[port] = looks[port];
            for (Value[] messages : alphabet(alone)) {
                if (messages[port] != null) {
                    stimuli.add(event(port, messages[port], latched));
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

    private List<Value[]> alphabet(Look[] looks) {
        Alphabet alphabet;
        try {
            alphabet = Alphabet.of(ports, new Attention(List.of(looks)));
        } catch (TooManyMessages problem) {
            alphabet = Alphabet.of(ports, new Attention(sampled(looks)));
        }
        List<Value[]> letters = new ArrayList<>(alphabet.size());
        for (int i = 0; i < alphabet.size(); i++) {
            letters.add(alphabet.letter(i));
        }
        return letters;
    }

    private List<Look> sampled(Look[] looks) {
        List<Look> some = new ArrayList<>();
        for (int i = 0; i < looks.length; i++) {
            boolean all = !(looks[i] instanceof Whole) || isSmall(ports.get(i).type());
            some.add(all ? looks[i] : sample(ports.get(i)));
        }
        return some;
    }

    private static boolean isSmall(Type type) {
        return type instanceof Type.BooleanType
                || type instanceof Type.EnumType
                || type instanceof Type.IntegerType range
                        && range.high() - range.low() >= 0
                        && range.high() - range.low() < FEW;
    }

    private Look sample(Port port) {
        Type type = port.type();
        sampled =
                "only some values of port '%s' were tried, %s has too many"
                        .formatted(port.name(), type.name());
        boolean number = type instanceof Type.IntegerType || type instanceof Type.RealType;
        return new Compared(mentioned.stream().filter(v -> isOf(v, type)).toList(), number);
    }

    private static boolean isOf(Value value, Type type) {
        if (type instanceof Type.IntegerType range) {
            return value instanceof Value.IntegerValue number
                    && range.low() <= number.value()
                    && number.value() <= range.high();
        }
        if (type instanceof Type.RealType) {
            return value instanceof Value.RealValue;
        }
        if (type instanceof Type.CharacterType) {
            return value instanceof Value.CharacterValue;
        }
        return type instanceof Type.StringType && value instanceof Value.StringValue;
    }
}

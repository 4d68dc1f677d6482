package montiarc7;

import montiarc7.grammar.MontiArc7Parser.AutomatonElementContext;
import montiarc7.grammar.MontiArc7Parser.ComponentContext;
import montiarc7.grammar.MontiArc7Parser.ComputeElementContext;
import montiarc7.grammar.MontiArc7Parser.ElementContext;
import montiarc7.grammar.MontiArc7Parser.MarkContext;
import montiarc7.grammar.MontiArc7Parser.PortDeclarationContext;
import montiarc7.grammar.MontiArc7Parser.PortsElementContext;
import montiarc7.grammar.MontiArc7Parser.TimingElementContext;
import montiarc7.source.Lack;
import montiarc7.source.Lacks;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** What a component says of time, at its ports and its behaviour. */
final class Timing {
    private final Set<String> words = new HashSet<>();
    private final Set<String> delayed = new HashSet<>();
    private boolean allDelayed;
    private boolean ticks;
    private boolean events;

    /** Whether something is done at the start, and nothing else ever. */
    private boolean isStartOnly;

    private boolean isSynchronous;

    /**
     * @param elements those of the component that are there together
     */
    Timing(ComponentContext component, List<ElementContext> elements, Lacks lacks) {
        for (ElementContext element : elements) {
            add(element, lacks);
        }
        isSynchronous = words.contains("sync") || words.contains("instant");
        if (events && (ticks || isSynchronous)) {
            lacks.missing(
                    Lack.TICKS_AND_EVENTS,
                    component.name(0),
                    "'%s' reacts to messages and to ticks; a component of Arcomat works by slices or by events"
                            .formatted(component.name(0).getText()));
        }
    }

    private void add(ElementContext element, Lacks lacks) {
        if (element instanceof PortsElementContext ports) {
            ports.portDeclaration().forEach(this::add);
        } else if (element instanceof TimingElementContext timing) {
            words.add(timing.name().getText());
        } else if (element instanceof ComputeElementContext compute) {
            marks(compute.mark());
        } else if (element instanceof AutomatonElementContext automaton) {
            marks(automaton.mark());
            Machine machine = new Machine(automaton.machineElement(), lacks.unheard());
            for (Transition each : machine.transitions()) {
                boolean isEvent = each.trigger().isPresent();
                events |= isEvent;
                ticks |= !isEvent;
            }
            isStartOnly = machine.transitions().isEmpty() && machine.isBusyAtStartOnly();
        }
    }

    private void add(PortDeclarationContext ports) {
        List<String> said = new ArrayList<>();
        ports.mark().forEach(each -> said.addAll(words(each)));
        if (said.contains("delayed") && ports.direction.getText().equals("out")) {
            ports.name().forEach(each -> delayed.add(each.getText()));
        }
        words.addAll(said);
    }

    private void marks(List<MarkContext> marks) {
        for (MarkContext each : marks) {
            allDelayed |= words(each).contains("delayed");
            words.addAll(words(each));
        }
    }

    private static List<String> words(MarkContext mark) {
        return mark.stereo() == null
                ? List.of(mark.getText())
                : mark.stereo().stereoValue().stream()
                        .map(each -> each.name().getText())
                        .flatMap(each -> meaning(each).stream())
                        .toList();
    }

    /** A word of older models means two of today. */
    private static List<String> meaning(String word) {
        return word.equals("causalsync") ? List.of("sync", "delayed") : List.of(word);
    }

    /** Whether steps are events; slices else. */
    boolean isByEvents() {
        boolean isUntimed = words.contains("untimed") || isStartOnly && !isSynchronous;
        return events || isUntimed && !ticks;
    }

    /** Whether all that happens belongs to slices, as it says itself. */
    boolean isSynchronous() {
        return isSynchronous;
    }

    boolean isDelayed(String port) {
        return allDelayed || delayed.contains(port);
    }
}

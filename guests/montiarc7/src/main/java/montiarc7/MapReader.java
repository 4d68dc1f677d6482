package montiarc7;

import arcomat.source.SourceFile;

import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.MapEntryContext;
import montiarc7.grammar.MontiArc7Parser.MapPartContext;
import montiarc7.grammar.MontiArc7Parser.MappingContext;
import montiarc7.source.Lack;
import montiarc7.source.Lacks;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads a map of MontiArc's conformance: what stands for what between a concrete component, on the
 * left of each entry, and a reference. Which components these are is said by their states.
 */
final class MapReader {
    private static final Pattern STATE = Pattern.compile("(?:\\w+\\.)?state==(?:\\w+\\.)?(\\w+)");

    private final MappingContext mapping;
    private final Lacks lacks;

    MapReader(SourceFile file, Lacks lacks) {
        this.mapping = MontiArcText.mapping(file, lacks);
        this.lacks = lacks;
    }

    /** A map for each concrete component that it fits, by name. */
    Map<String, String> maps(List<MapSide> sides) {
        Map<String, String> maps = new LinkedHashMap<>();
        if (lacks.isAny()) {
            return maps;
        }
        List<MapSide> concrete = with(sides, states(entry -> entry.expression(0)));
        List<MapSide> reference = with(sides, states(entry -> entry.expression(1)));
        if (concrete.isEmpty() || reference.size() != 1 || concrete.contains(reference.get(0))) {
            lacks.missing(
                    Lack.MAP,
                    mapping.name(),
                    "it is not clear which components '%s' is about: name states of one reference and of what conforms to it in 'stateMap', and put their files into its folder"
                            .formatted(mapping.name().getText()));
            return maps;
        }
        noteStates(concrete, reference.get(0));
        for (MapSide each : concrete) {
            String name =
                    mapping.name().getText() + (concrete.size() > 1 ? "Of" + each.name() : "");
            maps.put(name, new MapWriter(name, each, reference.get(0), lacks).write(mapping));
        }
        return lacks.isAny() ? Map.of() : maps;
    }

    /** MontiArc's conformance begins in all pairs of states that the map allows. */
    private void noteStates(List<MapSide> concrete, MapSide reference) {
        lacks.note(
                Lack.MAP_NOTE,
                mapping.name(),
                "states are not compared: 'refines --map' asks about runs from the initial states"
                        + " on, so 'stateMap' is left out");
        List<String> left = states(entry -> entry.expression(0));
        List<String> right = states(entry -> entry.expression(1));
        for (MapSide each : concrete) {
            int at = left.indexOf(each.initial());
            if (at >= 0
                    && left.size() == right.size()
                    && !right.get(at).equals(reference.initial())) {
                lacks.note(
                        Lack.MAP_NOTE,
                        mapping.name(),
                        "'%s' begins with '%s', which stands for '%s', and '%s' begins with '%s'; MontiArc does not look at that, and 'refines' does"
                                .formatted(
                                        each.name(),
                                        each.initial(),
                                        right.get(at),
                                        reference.name(),
                                        reference.initial()));
            }
        }
    }

    private List<String> states(Function<MapEntryContext, ExpressionContext> side) {
        List<String> states = new ArrayList<>();
        for (MapPartContext part : mapping.mapPart()) {
            if (part.kind.getText().equals("stateMap")) {
                for (MapEntryContext each : part.mapEntry()) {
                    Matcher state = STATE.matcher(side.apply(each).getText());
                    if (state.find()) {
                        states.add(state.group(1));
                    }
                }
            }
        }
        return states;
    }

    private static List<MapSide> with(List<MapSide> sides, List<String> states) {
        return states.isEmpty()
                ? List.of()
                : sides.stream().filter(each -> each.states().containsAll(states)).toList();
    }
}

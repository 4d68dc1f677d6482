package montiarc7.source;

import montiarc7.grammar.MontiArc7Parser.ElementContext;
import montiarc7.grammar.MontiArc7Parser.GroupElementContext;
import montiarc7.grammar.MontiArc7Parser.SoleModeElementContext;
import montiarc7.grammar.MontiArc7Parser.VariationElementContext;

import java.util.ArrayList;
import java.util.List;

/**
 * An element of a component, and on which sides of variations it stands, from the outside in. What
 * a constant condition rules out is not there.
 *
 * @param sides none where it is there in all variants
 */
public record Placed(ElementContext element, List<Side> sides) {
    /**
     * One side of a variation.
     *
     * @param holds whether its condition is true there
     */
    public record Side(VariationElementContext variation, boolean holds) {
        boolean excludes(Side other) {
            return variation == other.variation && holds != other.holds;
        }
    }

    /** All elements, those in variations too, in the order of the text. */
    public static List<Placed> of(List<ElementContext> elements) {
        List<Placed> all = new ArrayList<>();
        collect(elements, List.of(), all);
        return all;
    }

    private static void collect(List<ElementContext> elements, List<Side> sides, List<Placed> all) {
        for (ElementContext each : elements) {
            if (each instanceof GroupElementContext group) {
                collect(group.element(), sides, all);
            } else if (each instanceof SoleModeElementContext mode) {
                collect(mode.element(), sides, all);
            } else if (each instanceof VariationElementContext variation && isDecided(variation)) {
                collect(decided(variation), sides, all);
            } else if (each instanceof VariationElementContext variation) {
                collect(List.of(variation.element(0)), and(sides, variation, true), all);
                if (variation.element().size() > 1) {
                    collect(List.of(variation.element(1)), and(sides, variation, false), all);
                }
            } else {
                all.add(new Placed(each, sides));
            }
        }
    }

    /** Whether the condition of a variation is the same for all choices of features. */
    public static boolean isDecided(VariationElementContext variation) {
        return Constants.truth(variation.expression()).isPresent();
    }

    /** Of a variation that is decided, the side that is there. */
    public static List<ElementContext> decided(VariationElementContext variation) {
        boolean holds = Constants.truth(variation.expression()).orElseThrow();
        return variation.element().stream().skip(holds ? 0 : 1).limit(1).toList();
    }

    public static List<Side> and(
            List<Side> sides, VariationElementContext variation, boolean holds) {
        List<Side> all = new ArrayList<>(sides);
        all.add(new Side(variation, holds));
        return List.copyOf(all);
    }

    /** Whether some variant has the element and what stands on other sides. */
    public boolean goesWith(List<Side> others) {
        return sides.stream().noneMatch(each -> others.stream().anyMatch(each::excludes));
    }
}

package arcomat.pipeline.gate;

import arcomat.source.Span;
import arcomat.tree.Name;
import arcomat.tree.Stereotype;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The reasons that models give for promises that are not kept: {@code <<breaks = "reason">>} on a
 * component, {@code <<replaces = "p.Old: reason">>} on any component for one that is gone. A reason
 * that the base has, too, was given for an earlier change, and is good for nothing any more.
 */
final class BreakReasons {
    private static final String BREAKS = "breaks";
    static final String REPLACES = "replaces";

    private final List<Replacement> replacements = new ArrayList<>();
    private final Set<Span> used = new HashSet<>();
    private final GateSide base;

    /**
     * @param gone a component, or a package of which all that is gone is meant
     */
    private record Replacement(Stereotype written, String gone, String reason) {
        boolean isAbout(String name) {
            return name.equals(gone) || name.startsWith(gone + ".");
        }
    }

    /** A stereotype without effect, and whether the base has it, too. */
    record Unneeded(Stereotype stereotype, boolean spent) {}

    BreakReasons(GateSide base, GateSide fresh) {
        this.base = base;
        fresh.components().forEach(this::addReplacements);
    }

    private void addReplacements(String name, GateSide.Declared component) {
        for (Stereotype each : named(component, REPLACES)) {
            if (!isSpent(name, each)) {
                String text = value(each);
                int colon = text.indexOf(':');
                String gone = text.substring(0, colon).strip();
                replacements.add(new Replacement(each, gone, text.substring(colon + 1).strip()));
            }
        }
    }

    /** Why a component does not keep what it promised. */
    Optional<String> breaks(String name, GateSide.Declared component) {
        for (Stereotype each : named(component, BREAKS)) {
            if (!isSpent(name, each)) {
                used.add(each.span());
                return Optional.of(value(each).strip());
            }
        }
        return Optional.empty();
    }

    /** Whether there is a reason that was good for an earlier change. */
    boolean hasSpent(String name, GateSide.Declared component) {
        return named(component, BREAKS).stream().anyMatch(each -> isSpent(name, each));
    }

    /** Why a component is gone. */
    Optional<String> gone(String name) {
        Optional<Replacement> found =
                replacements.stream().filter(each -> each.isAbout(name)).findFirst();
        found.ifPresent(each -> used.add(each.written().span()));
        return found.map(Replacement::reason);
    }

    /** The reasons on a component that nothing asked for. */
    List<Unneeded> unneeded(String name, GateSide.Declared component) {
        List<Unneeded> unneeded = new ArrayList<>();
        for (Stereotype each : component.stereotypes()) {
            String kind = each.name().text();
            if ((kind.equals(BREAKS) || kind.equals(REPLACES)) && !used.contains(each.span())) {
                unneeded.add(new Unneeded(each, isSpent(name, each)));
            }
        }
        return unneeded;
    }

    private boolean isSpent(String name, Stereotype stereotype) {
        GateSide.Declared old = base.components().get(name);
        return old != null
                && named(old, stereotype.name().text()).stream()
                        .anyMatch(each -> value(each).equals(value(stereotype)));
    }

    private static List<Stereotype> named(GateSide.Declared component, String kind) {
        return component.stereotypes().stream()
                .filter(each -> each.name().text().equals(kind) && each.value().isPresent())
                .toList();
    }

    private static String value(Stereotype stereotype) {
        return stereotype.value().map(Name::text).orElse("");
    }
}

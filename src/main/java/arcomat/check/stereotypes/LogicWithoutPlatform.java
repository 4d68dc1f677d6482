package arcomat.check.stereotypes;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.signatures.Layer;
import arcomat.tree.Stereotype;

import java.util.List;
import java.util.stream.Collectors;

/**
 * ARC0504: the logic of a robot neither is a platform component nor contains one. A platform
 * component without a layer would count as logic; a composite without one joins the layers.
 */
public final class LogicWithoutPlatform implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        if (component.signature().layer() != Layer.LOGIC || hasUnknownLayer(component)) {
            return;
        }
        if (component.isPlatform()) {
            findings.report(
                    component.nameSpan(),
                    "platform component '%s' cannot belong to the logic; add <<layer ="
                            + " \"sensors\">> or <<layer = \"actuators\">>",
                    component.name());
            return;
        }
        List<InstanceSymbol> path =
                Layers.isWritten(component) ? Layers.pathToPlatform(component) : List.of();
        if (!path.isEmpty()) {
            InstanceSymbol device = path.get(path.size() - 1);
            findings.report(
                            path.get(0).nameSpan(),
                            "'%s' is logic, but contains the platform component '%s'; connect the"
                                    + " device from outside",
                            component.name(),
                            text(path))
                    .related(device.component().orElseThrow().nameSpan(), "the platform component");
        }
    }

    private static boolean hasUnknownLayer(ComponentSymbol component) {
        return Stereotype.find(component.stereotypes(), "layer")
                .filter(s -> s.value().flatMap(v -> Layer.named(v.text())).isEmpty())
                .isPresent();
    }

    private static String text(List<InstanceSymbol> path) {
        return path.stream().map(InstanceSymbol::name).collect(Collectors.joining("."));
    }
}

package arcomat.generate;

import arcomat.model.Component;
import arcomat.model.Parameter;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.network.Network;
import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * ARC0806: two devices of one robot in one socket. Which enums name sockets is for the target to
 * say; platform components have them as parameters.
 */
final class Sockets {
    private static final String CODE = "ARC0806";

    /** Qualified names of enums. */
    private final Set<String> types;

    private Sockets(Set<String> types) {
        this.types = types;
    }

    static List<Diagnostic> check(Request request, Target target) {
        String names = target.entries().getOrDefault("sockets", "").strip();
        if (names.isEmpty()) {
            return List.of();
        }
        Sockets sockets = new Sockets(Set.of(names.split("\\s+")));
        List<Diagnostic> findings = new ArrayList<>();
        request.programs().forEach(main -> sockets.check(main, findings));
        return findings;
    }

    /** A device with one of its sockets. */
    private record Use(String device, Type.EnumType type, Value socket) {}

    private void check(Component main, List<Diagnostic> findings) {
        List<Use> uses = new ArrayList<>();
        for (Network.Device device : Network.of(main, List.of()).devices()) {
            List<Parameter> parameters = device.component().parameters();
            for (int i = 0; i < parameters.size(); i++) {
                if (parameters.get(i).type() instanceof Type.EnumType type
                        && types.contains(type.name())) {
                    uses.add(new Use(device.path(), type, device.arguments().get(i)));
                }
            }
        }
        Map<Value, String> owners = new LinkedHashMap<>();
        for (Use use : uses) {
            String owner = owners.putIfAbsent(use.socket(), use.device());
            if (owner != null) {
                String message = message(use, owner, free(use.type(), uses));
                findings.add(Diagnostic.error(CODE, span(main, use.device()), message));
            }
        }
    }

    private static List<String> free(Type.EnumType type, List<Use> uses) {
        List<String> free = new ArrayList<>(type.constants());
        uses.forEach(use -> free.remove(use.socket().toString()));
        return free;
    }

    private static String message(Use use, String owner, List<String> free) {
        return "'"
                + use.device()
                + "' is plugged into socket "
                + use.socket()
                + " like '"
                + owner
                + "'; "
                + (free.isEmpty()
                        ? "no other is free: do without one of the devices"
                        : "free are " + String.join(", ", free));
    }

    /** The declaration of an instance, which may be deep inside of the whole. */
    private static Span span(Component whole, String path) {
        if (whole.body() instanceof Component.Composite body) {
            for (Component.Part part : body.parts()) {
                if (path.equals(part.name())) {
                    return part.span();
                }
                if (path.startsWith(part.name() + ".")) {
                    return span(part.component(), path.substring(part.name().length() + 1));
                }
            }
        }
        return whole.span();
    }
}

package arcomat.symbols;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;

/** Connectors between parts without ports lead where a rule says that is written to be read. */
class PartEndsTest {
    private static final List<String> NAMES = List.of("a", "b", "c");
    private static final List<String> TYPES =
            List.of("Integer", "Integer", "Boolean", "Integer[0..3]");

    private record Port(boolean input, String type, String name) {
        String declaration() {
            return (input ? "in " : "out ") + type + " " + name;
        }
    }

    @Property(tries = 500, seed = "1")
    void anEndIsCompletedWhereItIsClearWhatIsMeant(@ForAll long seed) {
        Random random = new Random(seed);
        List<Port> left = ports(random);
        List<Port> right = ports(random);
        Port own = new Port(true, one(TYPES, random), one(NAMES, random));

        assertThat(connected("left -> right", own, left, right))
                .isEqualTo(wanted(left, right, "left.", "right."));
        assertThat(connected(own.name() + " -> right", own, left, right))
                .isEqualTo(wanted(List.of(sending(own)), right, "", "right."));
        for (Port sender : left) {
            if (!sender.input()) {
                assertThat(connected("left." + sender.name() + " -> right", own, left, right))
                        .isEqualTo(wanted(List.of(sender), right, "left.", "right."));
            }
        }
    }

    /** As it is seen from inside. */
    private static Port sending(Port own) {
        return new Port(false, own.type(), own.name());
    }

    private static List<Port> ports(Random random) {
        List<Port> ports = new ArrayList<>();
        for (String name : NAMES) {
            if (random.nextInt(4) > 0) {
                ports.add(new Port(random.nextBoolean(), one(TYPES, random), name));
            }
        }
        return ports;
    }

    private static <T> T one(List<T> all, Random random) {
        return all.get(random.nextInt(all.size()));
    }

    /** One pair of ports alone fits and has one name; or none has one name, and one pair fits. */
    private static String wanted(List<Port> from, List<Port> to, String sender, String receiver) {
        TreeSet<String> alike = new TreeSet<>();
        TreeSet<String> all = new TreeSet<>();
        for (Port source : from) {
            for (Port target : to) {
                if (!source.input() && target.input() && fit(source.type(), target.type())) {
                    String pair = sender + source.name() + " -> " + receiver + target.name();
                    all.add(pair);
                    if (source.name().equals(target.name())) {
                        alike.add(pair);
                    }
                }
            }
        }
        TreeSet<String> meant = alike.isEmpty() ? all : alike;
        return meant.size() == 1 ? meant.first() : "unclear";
    }

    private static boolean fit(String from, String to) {
        return from.equals(to) || from.equals("Integer[0..3]") && to.equals("Integer");
    }

    private static String connected(String connector, Port own, List<Port> left, List<Port> right) {
        String text =
                "==== p/Whole.arc\npackage p; component Whole { port %s; component Left left; component Right right; connect %s; }\n"
                                .formatted(own.declaration(), connector)
                        + component("Left", left)
                        + component("Right", right);
        ComponentSymbol whole = Scenario.of(text).workspace().components("p.Whole").get(0);
        ConnectorSymbol found = whole.connectors().get(0);
        return found.isResolved()
                ? found.source().key() + " -> " + found.target().key()
                : "unclear";
    }

    private static String component(String name, List<Port> ports) {
        StringBuilder text = new StringBuilder();
        text.append("==== p/").append(name).append(".arc\npackage p; component ").append(name);
        text.append(" { ");
        ports.forEach(port -> text.append("port ").append(port.declaration()).append("; "));
        return text.append("}\n").toString();
    }
}

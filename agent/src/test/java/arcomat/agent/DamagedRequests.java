package arcomat.agent;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Requests of every method, each damaged in one to three places: members that are missing, that
 * have a value of another kind, and texts that are cut or mixed up. The same for the same seed.
 */
final class DamagedRequests {
    private static final ObjectMapper JSON = new ObjectMapper();

    private static final List<String> WHOLE =
            List.of(
                    message(
                            "initialize",
                            "{\"protocolVersion\":\"2025-06-18\",\"capabilities\":{}}"),
                    message("ping", "{}"),
                    message("tools/list", "{\"cursor\":\"next\"}"),
                    message("prompts/list", "{}"),
                    message("notifications/initialized", "{}"),
                    message("notifications/cancelled", "{\"requestId\":7,\"reason\":\"late\"}"),
                    call("check", "{\"paths\":[\"models\"],\"profile\":\"executable\"}"),
                    call("explain", "{\"code\":\"ARC0104\"}"),
                    call("simulate", "{\"component\":\"p.Door\",\"slices\":2,\"seed\":1}"),
                    call("test", "{\"paths\":[\"models/p\"]}"),
                    call("refines", "{\"left\":\"p.Door\",\"right\":\"p.Door\"}"),
                    call("diagram", "{\"components\":[\"p.Door\"],\"depth\":1}"),
                    call(
                            "world",
                            "{\"world\":\"models/a.world\",\"seed\":1,\"set\":{\"a\":\"1\"}}"),
                    call("rest", "{\"answer\":1,\"part\":2}"));

    private static final List<String> ODD =
            List.of(
                    "null",
                    "true",
                    "[]",
                    "{}",
                    "-1",
                    "1.5",
                    "1e400",
                    "2147483648",
                    "\"\"",
                    "123456789012345678901234567890",
                    "\"\\ud800\"",
                    "[{\"a\":[null]}]",
                    "\"x\"");

    private final Random random;

    DamagedRequests(long seed) {
        this.random = new Random(seed);
    }

    private static String message(String method, String params) {
        return "{\"jsonrpc\":\"2.0\",\"id\":7,\"method\":\"%s\",\"params\":%s}"
                .formatted(method, params);
    }

    private static String call(String tool, String arguments) {
        return message(
                "tools/call", "{\"name\":\"%s\",\"arguments\":%s}".formatted(tool, arguments));
    }

    /** The next one: a line. */
    String next() throws IOException {
        ObjectNode message = (ObjectNode) JSON.readTree(pick(WHOLE));
        for (int damages = random.nextInt(1, 4); damages > 0; damages--) {
            damage(message);
        }
        String line = message.toString();
        return random.nextInt(3) == 0 ? mixedUp(line) : line;
    }

    private void damage(ObjectNode message) throws IOException {
        List<ObjectNode> objects = new ArrayList<>();
        collect(message, objects);
        ObjectNode object = pick(objects);
        List<String> names = new ArrayList<>();
        object.fieldNames().forEachRemaining(names::add);
        if (names.isEmpty() || random.nextInt(6) == 0) {
            object.set("more", JSON.readTree(pick(ODD)));
        } else if (random.nextBoolean()) {
            object.remove(pick(names));
        } else {
            object.set(pick(names), JSON.readTree(pick(ODD)));
        }
    }

    private static void collect(JsonNode node, List<ObjectNode> objects) {
        if (node instanceof ObjectNode object) {
            objects.add(object);
        }
        node.forEach(each -> collect(each, objects));
    }

    /** Cut, with a letter too many, or with a letter that is another one. */
    private String mixedUp(String line) {
        int at = random.nextInt(line.length());
        char letter = pick(List.of('{', '}', '[', '"', '\\', ',', ':', '0', 'e', '\u0000', 'ü'));
        return switch (random.nextInt(3)) {
            case 0 -> line.substring(0, at);
            case 1 -> line.substring(0, at) + letter + line.substring(at);
            default -> line.substring(0, at) + letter + line.substring(at + 1);
        };
    }

    private <T> T pick(List<T> all) {
        return all.get(random.nextInt(all.size()));
    }
}

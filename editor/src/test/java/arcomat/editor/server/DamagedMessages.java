package arcomat.editor.server;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Messages of every method that the server knows, each damaged in one to three places: members that
 * are missing, or have a value of another kind. The same for the same seed.
 */
final class DamagedMessages {
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
                    "\"x\"",
                    "[null]",
                    "2147483647",
                    "123456789012345678901234567890",
                    "\"file:///\"");

    private static final String PLACE =
            "{\"textDocument\":{\"uri\":\"ADDRESS\"},\"position\":{\"line\":3,\"character\":9}%s}";
    private static final String RANGE =
            "{\"start\":{\"line\":0,\"character\":0},\"end\":{\"line\":9,\"character\":0}}";
    private static final String RANGED =
            "{\"textDocument\":{\"uri\":\"ADDRESS\"},\"range\":" + RANGE + "%s}";
    private static final String FILE = "{\"textDocument\":{\"uri\":\"ADDRESS\"}}";
    private static final String ITEM =
            "{\"item\":{\"name\":\"Door\",\"kind\":5,\"uri\":\"ADDRESS\",\"range\":"
                    + RANGE
                    + ",\"selectionRange\":"
                    + RANGE
                    + ",\"data\":{\"address\":\"ADDRESS\",\"path\":\"p/Door.arc\",\"start\":22,"
                    + "\"kind\":\"COMPONENT\",\"name\":\"Door\"}}}";

    private static final List<String> WHOLE =
            List.of(
                    message("initialize", "{\"capabilities\":{\"workspace\":{}},\"rootUri\":null}"),
                    message("initialized", "{}"),
                    message("$/setTrace", "{\"value\":\"off\"}"),
                    message("$/cancelRequest", "{\"id\":7}"),
                    message("window/workDoneProgress/cancel", "{\"token\":1}"),
                    message("textDocument/unknown", "{}"),
                    message("textDocument/hover", PLACE.formatted("")),
                    message("textDocument/definition", PLACE.formatted("")),
                    message("textDocument/typeDefinition", PLACE.formatted("")),
                    message("textDocument/implementation", PLACE.formatted("")),
                    message("textDocument/documentHighlight", PLACE.formatted("")),
                    message("textDocument/prepareRename", PLACE.formatted("")),
                    message("textDocument/prepareCallHierarchy", PLACE.formatted("")),
                    message("textDocument/completion", PLACE.formatted("")),
                    message("textDocument/signatureHelp", PLACE.formatted("")),
                    message("textDocument/rename", PLACE.formatted(",\"newName\":\"Gate\"")),
                    message(
                            "textDocument/references",
                            PLACE.formatted(",\"context\":{\"includeDeclaration\":true}")),
                    message("textDocument/inlayHint", RANGED.formatted("")),
                    message(
                            "textDocument/codeAction",
                            RANGED.formatted(",\"context\":{\"diagnostics\":[]}")),
                    message(
                            "textDocument/rangeFormatting",
                            RANGED.formatted(",\"options\":{\"tabSize\":4}")),
                    message("textDocument/documentSymbol", FILE),
                    message("textDocument/foldingRange", FILE),
                    message("textDocument/codeLens", FILE),
                    message("textDocument/semanticTokens/full", FILE),
                    message("textDocument/didClose", FILE),
                    message("textDocument/didSave", FILE),
                    message(
                            "textDocument/formatting",
                            "{\"textDocument\":{\"uri\":\"ADDRESS\"},\"options\":{\"tabSize\":4}}"),
                    message(
                            "textDocument/selectionRange",
                            "{\"textDocument\":{\"uri\":\"ADDRESS\"},\"positions\":"
                                    + "[{\"line\":3,\"character\":9}]}"),
                    message(
                            "textDocument/didOpen",
                            "{\"textDocument\":{\"uri\":\"ADDRESS\",\"languageId\":\"arcomat\",\"version\":1,\"text\":\"package"
                                + " p;\\n"
                                + "component Door { }\"}}"),
                    message(
                            "textDocument/didChange",
                            "{\"textDocument\":{\"uri\":\"ADDRESS\",\"version\":2},"
                                    + "\"contentChanges\":[{\"range\":"
                                    + RANGE
                                    + ",\"text\":\"package p;\\ncomponent Door { }\"}]}"),
                    message("callHierarchy/incomingCalls", ITEM),
                    message("callHierarchy/outgoingCalls", ITEM),
                    message("workspace/symbol", "{\"query\":\"Do\"}"),
                    message(
                            "workspace/executeCommand",
                            "{\"command\":\"arcomat.show\",\"arguments\":[\"ADDRESS\",\"TEST\",\"x\"]}"),
                    message(
                            "workspace/didChangeConfiguration",
                            "{\"settings\":{\"arcomat\":{\"libraries\":[]}}}"),
                    message(
                            "workspace/didChangeWatchedFiles",
                            "{\"changes\":[{\"uri\":\"ADDRESS\",\"type\":2}]}"),
                    message(
                            "workspace/didChangeWorkspaceFolders",
                            "{\"event\":{\"added\":[],\"removed\":[{\"uri\":\"ADDRESS\","
                                    + "\"name\":\"x\"}]}}"));

    private final Random random;
    private final String address;

    /**
     * @param address of the file that the messages are about
     */
    DamagedMessages(long seed, String address) {
        this.random = new Random(seed);
        this.address = address;
    }

    private static String message(String method, String params) {
        boolean told = method.matches(".*/(did|cancel|set)[A-Z].*|initialized");
        return "{\"jsonrpc\":\"2.0\",%s\"method\":\"%s\",\"params\":%s}"
                .formatted(told ? "" : "\"id\":7,", method, params);
    }

    /** The next one. */
    String next() {
        JsonObject message = json(whole()).getAsJsonObject();
        for (int damages = random.nextInt(1, 4); damages > 0; damages--) {
            damage(message);
        }
        String text = message.toString();
        return random.nextInt(10) == 0 ? text.substring(0, random.nextInt(text.length())) : text;
    }

    private static JsonElement json(String text) {
        return new Gson().fromJson(text, JsonElement.class);
    }

    private String whole() {
        return pick(WHOLE).replace("ADDRESS", address);
    }

    private void damage(JsonObject message) {
        List<JsonObject> objects = new ArrayList<>();
        collect(message, objects);
        JsonObject object = pick(objects);
        List<String> names = List.copyOf(object.keySet());
        if (!names.isEmpty() && random.nextBoolean()) {
            object.remove(pick(names));
        } else {
            String name = names.isEmpty() ? "more" : pick(names);
            object.add(name, json(pick(ODD)));
        }
    }

    private static void collect(JsonElement element, List<JsonObject> objects) {
        if (element instanceof JsonObject object) {
            objects.add(object);
            object.asMap().values().forEach(each -> collect(each, objects));
        } else if (element instanceof JsonArray list) {
            list.forEach(each -> collect(each, objects));
        }
    }

    private <T> T pick(List<T> all) {
        return all.get(random.nextInt(all.size()));
    }
}

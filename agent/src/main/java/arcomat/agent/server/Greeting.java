package arcomat.agent.server;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;

import java.util.List;

/**
 * How a server answers the first request: with itself, and with the newest version of the protocol
 * that both know.
 */
record Greeting(String version) {
    /** Of the protocol, newest first; those between them differ in what is not used here. */
    private static final List<String> VERSIONS = List.of("2025-11-25", "2025-06-18", "2024-11-05");

    private static final String INSTRUCTIONS =
            "Arcomat checks, runs and proves component models for robots (.arc, .cd, .mt, .world)."
                    + " Each tool is a command of its command line and answers the same JSON;"
                    + " files are named relative to the folder that the server was started in, as"
                    + " findings name them. Check first; 'explain' tells what a code means. Tools"
                    + " change no files.";

    JsonObject answer(JsonObject asked) {
        JsonObject tools = new JsonObject();
        tools.addProperty("listChanged", false);
        JsonObject capabilities = new JsonObject();
        capabilities.add("tools", tools);
        JsonObject server = new JsonObject();
        server.addProperty("name", "arcomat");
        server.addProperty("version", version);
        JsonObject answer = new JsonObject();
        answer.addProperty("protocolVersion", protocol(asked.get("protocolVersion")));
        answer.add("capabilities", capabilities);
        answer.add("serverInfo", server);
        answer.addProperty("instructions", INSTRUCTIONS);
        return answer;
    }

    /** Versions are dates: the newest one that is not newer than what the agent knows. */
    private static String protocol(JsonElement asked) {
        if (asked == null || !asked.isJsonPrimitive()) {
            return VERSIONS.get(0);
        }
        return VERSIONS.stream()
                .filter(each -> each.compareTo(asked.getAsString()) <= 0)
                .findFirst()
                .orElse(VERSIONS.get(0));
    }
}

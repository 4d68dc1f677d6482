package arcomat.editor.server;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/** What settings of editors say of models of others: {@code {"libraries": ["DIR"]}}. */
final class LibrarySetting {
    private static final String NAME = "libraries";

    /** Below which an editor keeps the settings of this server. */
    private static final String SECTION = "arcomat";

    private LibrarySetting() {}

    /** The folders as they are written; whatever is no list of words names none. */
    static List<String> in(@Nullable Object settings) {
        List<String> folders = new ArrayList<>();
        if (settings instanceof JsonObject options && options.get(NAME) instanceof JsonArray list) {
            for (JsonElement each : list) {
                if (each.isJsonPrimitive() && !each.getAsString().isBlank()) {
                    folders.add(each.getAsString());
                }
            }
        }
        return folders;
    }

    /** Of all settings of an editor, those for this server; nothing where there are none. */
    static @Nullable Object section(@Nullable Object settings) {
        return settings instanceof JsonObject all ? all.get(SECTION) : null;
    }
}

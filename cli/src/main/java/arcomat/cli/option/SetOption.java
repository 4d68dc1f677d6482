package arcomat.cli.option;

import arcomat.pipeline.WrongUse;

import picocli.CommandLine.Option;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Of commands that run worlds: values of their parameters. */
public final class SetOption {
    @Option(
            names = "--set",
            paramLabel = "NAME=VALUE",
            description = "The value of a parameter of the world; may be given several times.")
    private List<String> settings = List.of();

    /** By the names of parameters, in the order of the command line. */
    public Map<String, String> values() throws WrongUse {
        Map<String, String> values = new LinkedHashMap<>();
        for (String setting : settings) {
            int equals = setting.indexOf('=');
            if (equals < 1 || equals == setting.length() - 1) {
                throw new WrongUse("--set %s is not NAME=VALUE", setting);
            }
            String name = setting.substring(0, equals);
            if (values.put(name, setting.substring(equals + 1)) != null) {
                throw new WrongUse("--set %s is given twice", name);
            }
        }
        return values;
    }

    /** The values as a person reads them, {@code ", a=1, b=2"}; empty where none is given. */
    public String shown() {
        StringBuilder shown = new StringBuilder();
        settings.forEach(setting -> shown.append(", ").append(setting));
        return shown.toString();
    }
}

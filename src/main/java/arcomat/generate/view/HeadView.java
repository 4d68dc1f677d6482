package arcomat.generate.view;

import java.util.List;

/**
 * What every generated component has.
 *
 * @param model qualified name in the model
 * @param file path of the model file
 * @param line of the declaration in it
 * @param draws whether the generator of choices is a parameter
 * @param mentions types that the file names briefly
 */
public record HeadView(
        String packageName,
        String prefix,
        String folder,
        String name,
        String model,
        String file,
        int line,
        boolean draws,
        List<TypeView> mentions,
        List<FieldView> parameters,
        List<PortView> inputs,
        List<PortView> outputs) {}

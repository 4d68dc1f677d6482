# ${component}

<#if campaign>
Two robots that drive around in a yard and keep away from walls and from each other.
<#elseif robot>
A robot that drives until something is near, turns, and goes on.
<#else>
A pilot that drives until something is near, turns, and goes on: logic without a robot around it.
</#if>

| file | is |
|---|---|
<#if robot>
| `src/main/arc/${packageName}/${component}.arc` | the robot: sensor, logic, motors, display |
</#if>
| `src/main/arc/${packageName}/${component}Signals.cd` | what its parts tell each other |
| `src/main/arc/${packageName}/${component}Promise.arc` | what has to be kept, however it is built |
| `src/main/arc/${packageName}/${component}Pilot.arc` | what it does: an automaton that keeps the promise |
<#if robot>
| `src/main/arc/${packageName}/${component}Wheels.arc` | what that means for two wheels |
</#if>
| `src/test/arc/${packageName}/${component}PilotTest.mt` | tests: what goes in, what has to come out |
<#if robot>
| `${name}.world` | the floor that it drives on |
</#if>
<#if campaign>
| `${name}.campaign` | many runs of that world, and what they have to show |
</#if>

In this folder:

```sh
arcomat check .
arcomat test .
arcomat verify .
<#if robot>
arcomat world ${name}.world
arcomat generate --target lejos --out build/brick src/main/arc
<#else>
arcomat simulate --main ${packageName}.${component}Pilot src/main/arc
</#if>
<#if campaign>
arcomat campaign ${name}.campaign
</#if>
```

`arcomat watch .` does what is needed of it at each save. `gradle build` does all of it, as in `.github/workflows/models.yml`.

## What to try next

1. Write 10 instead of 30 in `${component}Pilot.arc`. Does `arcomat test` find it? Does `arcomat verify`?
2. Have the pilot count its turns in a variable, and give up after ten.
<#if robot>
3. Put another wall into `${name}.world`. Can you trap the robot?
</#if>

<#if !campaign>
# A yard with a wall across it. Lengths in mm, angles in degrees, 0 along x and growing to the left.
# Try: a second wall, or --seed 2, or --report build/yard for a page that plays the run again.
floor 3000 2000
seconds 30
<#else>
# Two robots in a yard. Lengths in mm, angles in degrees, 0 along x and growing to the left.
# Try: arcomat world ${name}.world --set apart=600, or --report build/yard for a page that plays the run.
parameter apart 1600
parameter sonar 1

floor 3000 2000
seconds 30
noise light 1 distance $sonar
</#if>

wall 0 0  3000 0
wall 3000 0  3000 2000
wall 3000 2000  0 2000
wall 0 2000  0 0
<#if !campaign>
wall 2000 500  2000 1500
</#if>

kind ${packageName}
  program component ${packageName}.${component} in src/main/arc
  body 80 900
  wheels A B
  ultrasonic S1 at 75 0

<#if !campaign>
robot ${packageName} ${packageName} at 600 1000
<#else>
robot first ${packageName} at 500 500 heading 0
robot second ${packageName} at $apart 1500 heading 180
</#if>

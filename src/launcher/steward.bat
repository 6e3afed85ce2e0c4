@echo off
rem Starts Steward on Windows, with all its jars and the exit status of the program. Untried: see docs/platforms.md.
setlocal
if defined JAVA_HOME (set "JAVA=%JAVA_HOME%\bin\java.exe") else (set "JAVA=java.exe")
"%JAVA%" --enable-native-access=ALL-UNNAMED %JAVA_OPTS% %STEWARD_OPTS% -classpath "%~dp0..\lib\*;%~dp0..\lib\machines\*" steward.cli.Main %*
exit /b %ERRORLEVEL%
